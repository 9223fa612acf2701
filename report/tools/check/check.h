#pragma once
// `luxgate check`: a batch of projects, calculated and judged.

#include "report/shell/command/command.h"
#include "report/tools/check/check_options.h"

namespace cli {

Command check_command();

// Runs the command. Prints results to standard output, everything else to standard error.
ExitCode run_check(const CheckOptions& options, const RunContext& context);

}  // namespace cli
