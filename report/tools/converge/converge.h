#pragma once
// `luxgate converge`: error against run time and rays.

#include "calc/base/file_reader.h"
#include "gpu/device/egl_context.h"
#include "report/shell/command/command.h"
#include "report/shell/process/environment.h"
#include "report/shell/process/print.h"
#include "report/tools/converge/converge_options.h"

namespace cli {

// Runs the command. Shows its progress on standard error, if that is a terminal. gl_fault: for
// tests.
CommandOutcome run_converge(const ConvergeOptions& options, const calc::FileReader& disk,
                            const Environment& environment, gpu::Fault gl_fault);

Command converge_command();

}  // namespace cli
