#pragma once
// A whole run of the program.

namespace cli {

// Parses, runs, turns exceptions into a message and kNotJudged. Results go to standard output,
// everything else to standard error. The exit status is an ExitCode.
int run_program(int argc, const char* const* argv);

}  // namespace cli
