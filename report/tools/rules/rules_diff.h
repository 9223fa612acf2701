#pragma once
// `luxgate rules diff`: in what two rule packs differ, and which verdicts of a project that
// changes.

#include "report/shell/command/command.h"

namespace cli {

Command diff_action();

}  // namespace cli
