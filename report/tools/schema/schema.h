#pragma once
// `luxgate schema`: the schemas of project files, of results and of sweeps.

#include "report/shell/command/command.h"

namespace cli {

Command schema_command();

}  // namespace cli
