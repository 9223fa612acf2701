#pragma once
// Every option of every command, as one table.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// Returns CSV: a line for each option of each command, with equal options below each other.
std::string option_table(const std::vector<Command>& commands);

}  // namespace cli
