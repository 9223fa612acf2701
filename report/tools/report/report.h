#pragma once
// `luxgate report`: writes a result in other formats, without calculating.

#include "report/document/revision.h"
#include "report/shell/command/command.h"
#include "report/shell/options/sandbox.h"
#include "report/shell/output/output_options.h"

#include <string>

namespace cli {

struct ReportOptions {
  std::string result_file;
  std::string baseline;  // a result to compare it with; "" = none
  report::Gate gate;
  OutputOptions output;
  SandboxMode sandbox = SandboxMode::automatic;
};

Command report_syntax(ReportOptions& options);
Command report_command();

}  // namespace cli
