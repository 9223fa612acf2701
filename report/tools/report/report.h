#pragma once
// `luxgate report`: a result in other formats, without calculating.

#include "report/shell/command.h"
#include "report/shell/output_options.h"

#include <string>

namespace cli {

struct ReportOptions {
  std::string result_file;
  OutputOptions output;
};

Command report_syntax(ReportOptions& options);
Command report_command();

}  // namespace cli
