#pragma once
// Whether a result says what follows from its own numbers: nobody may change a verdict, or a
// number under it, and still have a report of it.

#include "report/document/document.h"

namespace report {

// Judges again what can be judged from the document alone: every finding from its interval, limit,
// policy, doubts, deviations and waiver, with the result's own day; aggregates, classes and roles
// from the findings that they name; looks; projects from their errors. Where the document does not
// hold the ground of a verdict (why something is not judged), it is enough that no verdict is
// better than its grounds. Throws BadJson with the place as a JSON pointer, with project, plane and
// requirement, with what is said and what follows.
void refuse_contradictions(const Document& document);

}  // namespace report
