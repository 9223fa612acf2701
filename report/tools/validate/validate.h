#pragma once
// `luxgate validate`: everything that `check` reads and checks, without calculating.

#include "report/shell/command/command.h"

namespace cli {

Command validate_command();

}  // namespace cli
