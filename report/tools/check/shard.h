#pragma once
// `luxgate check --shard`: the light of some units of a batch, into a store.

#include "report/shell/command/command.h"
#include "report/tools/check/check_options.h"

namespace cli {

// Prints to standard error alone. kAllMet: all units of the shard are in the store.
ExitCode run_shard(const CheckOptions& options, const RunContext& context);

}  // namespace cli
