#pragma once
// Checks that a result agrees with its own numbers, so that a verdict, or a number under it, cannot
// be changed without being noticed.

#include "report/document/document.h"

namespace report {

// Judges again everything that the document allows: every finding from its interval, limit, policy,
// doubts, deviations and waiver, with the result's own day; aggregates, classes and roles from the
// findings that they name; sampling rounds; projects from their errors. If the document lacks the
// grounds of a verdict (why something is not judged), no verdict may be better than its grounds.
// Throws BadJson with the place as a JSON pointer, with project, plane and requirement, the stated
// verdict and the right one.
void refuse_contradictions(const Document& document);

}  // namespace report
