#pragma once
// `luxgate watch`: checks again whenever a file has changed.

#include "report/shell/command/command.h"

namespace cli {

Command watch_command();

}  // namespace cli
