#pragma once
// Runs the whole program.

namespace cli {

// Parses, runs, turns exceptions into a message and kNotJudged. Results go to standard output,
// everything else to standard error. Returns an ExitCode.
int run_program(int argc, const char* const* argv);

}  // namespace cli
