#pragma once
// Options that select a part of the projects' requirements.

#include "report/check/selection.h"
#include "report/shell/command/command.h"

#include <vector>

namespace cli {

// Returns --space, --plane, --tag and --require.
std::vector<Option> selection_options(check::Selection& selection);

// Prints the options that match nothing in any project.
void print_nothing_chosen(const check::Selection& selection);

}  // namespace cli
