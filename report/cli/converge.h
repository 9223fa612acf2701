#pragma once
// `luxgate converge`: error against run time and rays.

#include "calc/file_reader.h"
#include "gpu/egl_context.h"
#include "report/cli/command_outcome.h"
#include "report/cli/converge_options.h"
#include "report/cli/environment.h"

namespace cli {

// What is being done is told on standard error, if that is a terminal. gl_fault: for tests.
CommandOutcome run_converge(const ConvergeOptions& options, const calc::FileReader& disk,
                            const Environment& environment, gpu::Fault gl_fault);

}  // namespace cli
