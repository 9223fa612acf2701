#pragma once
// `luxgate schema`: the schemas of project files and of results.

#include "report/shell/command.h"

namespace cli {

Command schema_command();

}  // namespace cli
