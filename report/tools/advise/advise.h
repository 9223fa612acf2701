#pragma once
// `luxgate advise`: what would make a project pass, with the least energy.

#include "report/shell/command/command.h"

namespace cli {

Command advise_command();

}  // namespace cli
