#pragma once
// `luxgate help`, `completions` and `man`: the table of commands, for people and shells.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// Returns the command. names: of all commands, these three included.
Command help_command(const std::vector<std::string>& names);
Command completions_command();
Command man_command(const std::vector<std::string>& names);

}  // namespace cli
