#pragma once
// What a command has to say, for run() to print.

#include "calc/base/diagnostics.h"
#include "report/shell/exit_code.h"

#include <string>
#include <vector>

namespace cli {

struct CommandOutcome {
  ExitCode code = kAllMet;
  std::string text;  // for standard output
  std::vector<calc::Diagnostic> diagnostics;
};

}  // namespace cli
