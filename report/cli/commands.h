#pragma once
// The commands of luxgate, in the order of its help.

#include "report/shell/command/command.h"

#include <vector>

namespace cli {

std::vector<Command> all_commands();

}  // namespace cli
