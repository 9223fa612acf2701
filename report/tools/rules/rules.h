#pragma once
// `luxgate rules` and `luxgate explain`.

#include "report/shell/command/command.h"

namespace cli {

Command rules_command();
Command explain_command();

}  // namespace cli
