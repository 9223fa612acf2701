#pragma once
// `luxgate compare`: compares a result with another result, with another program's values or with
// measured values.

#include "calc/base/file_reader.h"
#include "report/shell/command/command.h"
#include "report/shell/process/print.h"
#include "report/tools/compare/compare_options.h"

namespace cli {

CommandOutcome run_compare(const CompareOptions& options, const calc::FileReader& disk);

Command compare_command();

}  // namespace cli
