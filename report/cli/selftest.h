#pragma once
// `luxgate selftest`: cases whose light is known exactly.

#include "report/cli/command_outcome.h"
#include "report/cli/environment.h"
#include "report/cli/selftest_options.h"

namespace cli {

CommandOutcome run_selftest(const SelftestOptions& options, const Environment& environment);

}  // namespace cli
