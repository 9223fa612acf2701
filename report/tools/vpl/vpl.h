#pragma once
// `luxgate vpl`: light vertices into a file.

#include "report/shell/command/command.h"

namespace cli {

Command vpl_command();

}  // namespace cli
