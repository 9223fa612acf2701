#pragma once
// A whole run of the program.

#include "report/cli/options.h"
#include "report/shell/environment.h"
#include "report/shell/exit_code.h"

namespace cli {

// Results go to standard output, everything else to standard error. Throws what our own mistakes
// and the machine throw (std::bad_alloc, ...).
ExitCode run(const Options& options, const Environment& environment);

// The program: parses, runs, turns exceptions into a message and kNotJudged.
int run_program(int argc, const char* const* argv);

}  // namespace cli
