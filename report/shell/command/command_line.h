#pragma once
// Reads the command line. Only command_line.cpp includes CLI11.

#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// Either the chosen command (or action), with its options set, or the text to print and the exit
// code: 0 for --help and --version, 2 for every usage error.
struct ParsedLine {
  const Command* command = nullptr;
  int exit_code = kAllMet;
  std::string out, err;
};

// Reads the line; argv[0] is the program. The result points into `commands`.
ParsedLine parse_command_line(const std::vector<Command>& commands, int argc,
                              const char* const* argv, const Environment& environment);

}  // namespace cli
