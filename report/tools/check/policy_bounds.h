#pragma once
// Compares a command with a policy, before anything is calculated.

#include "report/policy/policy.h"
#include "report/tools/check/check_options.h"

namespace cli {

// Returns false after errors, which are printed: options looser than the policy allows, a project
// that is not in the batch, a required format that is not written.
bool is_allowed_or_print(const report::Policy& policy, const CheckOptions& options);

}  // namespace cli
