#pragma once
// `luxgate policy`: explains files of --policy.

#include "report/shell/command/command.h"

namespace cli {

Command policy_command();

}  // namespace cli
