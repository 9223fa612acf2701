#pragma once
// `luxgate rules diff`: the differences of two rule packs, and the verdicts of a project that they
// change.

#include "report/shell/command/command.h"

namespace cli {

Command diff_action();

}  // namespace cli
