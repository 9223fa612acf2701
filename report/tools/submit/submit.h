#pragma once
// `luxgate submit`: a batch as a script for an engine that has many cores or machines.

#include "report/shell/command/command.h"

namespace cli {

Command submit_command();

}  // namespace cli
