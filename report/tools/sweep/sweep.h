#pragma once
// `luxgate sweep`: checks a project with many values.

#include "report/shell/command/command.h"
#include "report/shell/output/data_output.h"
#include "report/tools/check/check_options.h"
#include "report/tools/sweep/sweep_table.h"
#include "report/tools/sweep/vary.h"

#include <string>
#include <vector>

namespace cli {

struct SweepOptions {
  CheckOptions check;  // of one project; `set` is of all variants
  std::string project;
  std::vector<Vary> vary;
  std::vector<DataOutput> outputs;
  FrontOf front_of = FrontOf::power;
};

Command sweep_command();

// Runs the command, prints and writes. The verdicts of variants do not decide the code.
ExitCode run_sweep(const SweepOptions& options, const RunContext& context);

}  // namespace cli
