#pragma once
// `luxgate config`: which settings hold, and where they come from.

#include "report/shell/command/command.h"

namespace cli {

Command config_command();

}  // namespace cli
