#pragma once
// `luxgate validate`: reads and checks everything that `check` does, without calculating.

#include "report/shell/command/command.h"

namespace cli {

Command validate_command();

}  // namespace cli
