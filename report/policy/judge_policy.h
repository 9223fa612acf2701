#pragma once
// Compares a judged project with the owner's policy.

#include "report/document/document.h"
#include "report/policy/policy.h"

#include <string_view>

namespace report {

// Reports DiagnosticId::policy_not_met, which always counts, for each condition that the project
// does not meet. today: YYYY-MM-DD, the day of judging. A project that is not judged is not
// compared.
void judge_policy(const Policy& policy, std::string_view today, ProjectPart& project);

}  // namespace report
