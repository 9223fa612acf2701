#pragma once
// What a policy says of a command, before anything is calculated.

#include "report/policy/policy.h"
#include "report/tools/check/check_options.h"

namespace cli {

// False after errors, which have been printed: options that are looser than the policy allows, a
// project that is not in the batch, a format that is not written.
bool is_allowed_or_print(const report::Policy& policy, const CheckOptions& options);

}  // namespace cli
