#pragma once
// Completion scripts for shells. Commands, actions, options and the words that options accept come
// from the table of commands.

#include "report/shell/command/command.h"

#include <string>
#include <string_view>
#include <vector>

namespace cli {

enum class Shell { bash, zsh, fish };

std::string completions(Shell shell, const std::vector<Command>& commands);

}  // namespace cli
