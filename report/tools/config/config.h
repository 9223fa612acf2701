#pragma once
// `luxgate config`: shows the settings in effect and their sources.

#include "report/shell/command/command.h"

namespace cli {

Command config_command();

}  // namespace cli
