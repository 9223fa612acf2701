#pragma once
// `luxgate selftest`: cases whose light is known exactly.

#include "report/shell/command/command.h"
#include "report/shell/process/environment.h"
#include "report/shell/process/print.h"
#include "report/tools/selftest/selftest_options.h"

namespace cli {

CommandOutcome run_selftest(const SelftestOptions& options, const Environment& environment);

Command selftest_command();

}  // namespace cli
