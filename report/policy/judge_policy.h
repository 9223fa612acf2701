#pragma once
// A judged project against the owner's policy.

#include "report/document/document.h"
#include "report/policy/policy.h"

#include <string_view>

namespace report {

// What of the project is not as the policy wants it: DiagnosticId::policy_not_met for each, which
// always counts. today: YYYY-MM-DD, the day of judging. A project that is not judged has nothing
// else to fear.
void judge_policy(const Policy& policy, std::string_view today, ProjectPart& project);

}  // namespace report
