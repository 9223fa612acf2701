#pragma once
// Every option of every command, as one table.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// CSV: a line for each option of each command, the same options one below the other.
std::string option_table(const std::vector<Command>& commands);

}  // namespace cli
