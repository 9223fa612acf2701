#pragma once
// `luxgate vpl`: writes light vertices to a file.

#include "report/shell/command/command.h"

namespace cli {

Command vpl_command();

}  // namespace cli
