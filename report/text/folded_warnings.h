#pragma once
// Warnings of a project with several rooms for a terminal: repeated ones share a line.

#include "report/document/document.h"

#include <string>
#include <vector>

namespace report {

// Returns lines in English, in the order in which the warnings were found. Errors, warnings that
// count and single ones are whole; other warnings have one line for each id, with their number and
// the first of them, cut at `columns`; 0: never cut. If anything is hidden, the last line says how
// to show it.
std::vector<std::string> folded_warnings(const ProjectPart& project, int columns);

}  // namespace report
