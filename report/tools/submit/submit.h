#pragma once
// `luxgate submit`: writes a batch as a script for several cores or machines.

#include "report/shell/command/command.h"

namespace cli {

Command submit_command();

}  // namespace cli
