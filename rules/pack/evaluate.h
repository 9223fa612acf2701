#pragma once
// A rule pack against results that are already there: every check with its limit, verdicts of
// several checks as one, classes. For planes of a project, which are judged while their results
// grow, see bind.h and judge.h.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "rules/catalogue/compare.h"
#include "rules/pack/limit.h"
#include "rules/pack/rule_pack.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rules {

enum class CheckStatus {
  pass,
  fail,
  undecided,
  not_applicable,  // the row requires nothing: neither a pass nor a fail
  not_evaluated,   // something is missing
};
// "pass", "fail", "undecided", "not applicable", "not evaluated"
const char* status_name(CheckStatus status);
CheckStatus status_of(Verdict verdict);  // not judged: not evaluated

struct CheckResult {
  const RuleCheck* check = nullptr;
  CheckStatus status = CheckStatus::not_evaluated;
  std::optional<calc::Estimate> measured;  // base units
  Limit limit;
  bool is_close = false;
  bool by_tolerance = false;
  calc::Message reason;  // of not_applicable and not_evaluated
};

// What was measured for one row of a pack.
struct Evidence {
  const RulePack& pack;
  const RuleRow* row = nullptr;
  RowLevel level = RowLevel::required;
  std::map<std::string, double> facts = {};             // by id, in base units
  std::map<std::string, calc::Estimate> measured = {};  // by id of the check, in base units
  calc::SpecialPlace special = calc::SpecialPlace::none;
};

CheckResult evaluate_check(const RuleCheck& check, const Evidence& evidence);

// A status that counts for an aggregate as much as it weighs: 1, an area, a load.
struct WeightedStatus {
  CheckStatus status = CheckStatus::not_evaluated;
  double weight = 1.0;  // >= 0
};

// pass: whatever the open ones (undecided, not evaluated) turn out to be; fail: the same; else
// undecided. What is not applicable is left out; if nothing is left, so is the aggregate.
CheckStatus combine_statuses(const RuleAggregate& aggregate,
                             const std::vector<WeightedStatus>& members);

// Of the checks of one row and place.
CheckStatus evaluate_aggregate(const RuleAggregate& aggregate, const Evidence& evidence);

struct ClassResult {
  const RuleRow* reached = nullptr;   // the best class that is reached for certain; may be none
  const RuleRow* possible = nullptr;  // the best one that may be reached; may be none
};
// evidence.row is ignored.
ClassResult evaluate_class(const RuleClass& item, const Evidence& evidence);

}  // namespace rules
