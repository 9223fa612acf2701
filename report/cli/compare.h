#pragma once
// `luxgate compare`: a result against another one, another program's or measured values.

#include "calc/file_reader.h"
#include "report/cli/command_outcome.h"
#include "report/cli/compare_options.h"

namespace cli {

CommandOutcome run_compare(const CompareOptions& options, const calc::FileReader& disk);

}  // namespace cli
