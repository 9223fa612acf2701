#pragma once
// Options that choose a part of what projects require.

#include "report/check/selection.h"
#include "report/shell/command/command.h"

#include <vector>

namespace cli {

// --space, --plane, --tag, --require
std::vector<Option> selection_options(check::Selection& selection);

// Where one fits nothing in all projects.
void print_nothing_chosen(const check::Selection& selection);

}  // namespace cli
