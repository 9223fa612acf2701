#pragma once
// Reads the command line. command_line.cpp alone includes CLI11.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// Either the command (or action) that was chosen, its options set, or what to print and the exit
// code: 0 for --help and --version, 2 for every usage error.
struct ParsedLine {
  const Command* command = nullptr;
  int exit_code = kAllMet;
  std::string out, err;
};

// argv[0] is the program. The answer points into `commands`.
ParsedLine parse_command_line(const std::vector<Command>& commands, int argc,
                              const char* const* argv, const Environment& environment);

}  // namespace cli
