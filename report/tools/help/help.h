#pragma once
// `luxgate help`, `completions` and `man`: what the table of commands says, for people and shells.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// names: of all commands, these three too.
Command help_command(const std::vector<std::string>& names);
Command completions_command();
Command man_command(const std::vector<std::string>& names);

}  // namespace cli
