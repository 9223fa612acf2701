#pragma once
// Evaluates a rule pack against existing results: every check, and verdicts of several checks
// together. For planes of a project, judged while their results grow, see bind.h and judge.h.

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

// The measured values for one row of a pack.
struct Evidence {
  const RulePack& pack;
  const RuleRow* row = nullptr;
  RowLevel level = RowLevel::required;
  std::map<std::string, double> facts = {};             // by id, in base units
  std::map<std::string, calc::Estimate> measured = {};  // by id of the check, in base units
  calc::SpecialPlace special = calc::SpecialPlace::none;
};

CheckStatus evaluate_check(const RuleCheck& check, const Evidence& evidence);

// A status with its weight in an aggregate: 1, an area, a load.
struct WeightedStatus {
  CheckStatus status = CheckStatus::not_evaluated;
  double weight = 1.0;  // >= 0
};

// Returns pass or fail if the open members (undecided, not evaluated) cannot change it; else
// undecided. Members that are not applicable are omitted; if none is left, neither is the
// aggregate.
CheckStatus combine_statuses(const RuleAggregate& aggregate,
                             const std::vector<WeightedStatus>& members);

}  // namespace rules
