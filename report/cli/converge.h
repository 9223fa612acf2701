#pragma once
// `luxgate converge`: error against run time and rays.

#include "calc/file_reader.h"
#include "report/cli/command_outcome.h"
#include "report/cli/converge_options.h"

namespace cli {

// shows_progress: what is being done, on standard error.
CommandOutcome run_converge(const ConvergeOptions& options, const calc::FileReader& disk,
                            bool shows_progress);

}  // namespace cli
