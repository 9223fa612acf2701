#pragma once
// Warnings of a project of several rooms for a terminal: what comes again and again has a line.

#include "report/document/document.h"

#include <string>
#include <vector>

namespace report {

// Lines in English, in the order in which they were found. Errors, warnings that count and what is
// said once are whole; of other warnings there is one line for each id, with their number and the
// first of them, cut where it is wider than `columns`; 0: never. The last line says how all are
// shown, where that is not all of them.
std::vector<std::string> folded_warnings(const ProjectPart& project, int columns);

}  // namespace report
