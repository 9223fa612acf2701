#pragma once
// `luxgate check --shard`: calculates the light of some jobs of a batch into a store.

#include "report/shell/command/command.h"
#include "report/tools/check/check_options.h"

namespace cli {

// Prints only to standard error. Returns kAllMet if all jobs of the shard are in the store.
ExitCode run_shard(const CheckOptions& options, const RunContext& context);

}  // namespace cli
