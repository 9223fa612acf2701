#pragma once
// A rule pack against results that are already there: every check, and verdicts of several checks
// as one. For planes of a project, which are judged while their results grow, see bind.h and
// judge.h.

#include "calc/base/field.h"
#include "rules/catalogue/compare.h"
#include "rules/pack/rule_pack.h"

#include <map>
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
CheckStatus status_of(Verdict verdict);  // not judged: not evaluated

// What was measured for one row of a pack.
struct Evidence {
  const RulePack& pack;
  const RuleRow* row = nullptr;
  RowLevel level = RowLevel::required;
  std::map<std::string, double> facts = {};             // by id, in base units
  std::map<std::string, calc::Estimate> measured = {};  // by id of the check, in base units
  calc::SpecialPlace special = calc::SpecialPlace::none;
};

CheckStatus evaluate_check(const RuleCheck& check, const Evidence& evidence);

// A status that counts for an aggregate as much as it weighs: 1, an area, a load.
struct WeightedStatus {
  CheckStatus status = CheckStatus::not_evaluated;
  double weight = 1.0;  // >= 0
};

// pass: whatever the open ones (undecided, not evaluated) turn out to be; fail: the same; else
// undecided. What is not applicable is left out; if nothing is left, so is the aggregate.
CheckStatus combine_statuses(const RuleAggregate& aggregate,
                             const std::vector<WeightedStatus>& members);

}  // namespace rules
