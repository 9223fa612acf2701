#pragma once
// Checks of a rule pack with all that decides them, and several of them together, for cases that
// were worked out by hand.

#include "rules/catalogue/compare.h"
#include "rules/pack/evaluate.h"
#include "rules/pack/limit.h"

#include <optional>
#include <string>
#include <vector>

namespace rules {

inline std::string name_of_status(CheckStatus status) {
  switch (status) {
    case CheckStatus::pass:
      return "pass";
    case CheckStatus::fail:
      return "fail";
    case CheckStatus::undecided:
      return "undecided";
    case CheckStatus::not_applicable:
      return "not applicable";
    case CheckStatus::not_evaluated:
      return "not evaluated";
  }
  return "";
}

inline std::optional<calc::Estimate> measured_for(const RuleCheck& check,
                                                  const Evidence& evidence) {
  const auto found = evidence.measured.find(check.id);
  return found == evidence.measured.end() ? std::nullopt : std::optional(found->second);
}

inline Limit limit_of(const RuleCheck& check, const Evidence& evidence) {
  return evaluate_limit(
      check,
      {evidence.pack, evidence.row, evidence.level, evidence.facts,
       [&](const RuleCheck& other) { return measured_for(other, evidence); }, evidence.special});
}

// Of a check that has a limit and a result.
inline Decision decision_of(const RuleCheck& check, const Evidence& evidence) {
  const DecisionPolicy& policy = evidence.pack.policy;
  const int digits = policy.digits(check.dimension(), is_ratio(check.metric));
  return decide({measured_for(check, evidence).value(), check.comparison,
                 limit_of(check, evidence).value, digits},
                policy);
}

// Of all checks of one row and place.
inline CheckStatus evaluate_aggregate(const RuleAggregate& aggregate, const Evidence& evidence) {
  std::vector<WeightedStatus> members;
  for (const std::string& id : aggregate.checks) {
    members.push_back({evaluate_check(*evidence.pack.find_check(id), evidence), 1.0});
  }
  return combine_statuses(aggregate, members);
}

struct ClassResult {
  const RuleRow* reached = nullptr;   // the best class that is reached for certain; may be none
  const RuleRow* possible = nullptr;  // the best one that may be reached; may be none
};
// evidence.row is ignored.
inline ClassResult evaluate_class(const RuleClass& item, const Evidence& evidence) {
  ClassResult result;
  RuleAggregate all;
  all.checks = item.checks;
  Evidence of_class = evidence;
  for (const std::string& ref : item.rows) {
    of_class.row = evidence.pack.find_row(ref);
    const CheckStatus status = evaluate_aggregate(all, of_class);
    const bool is_open = status == CheckStatus::undecided;
    if (result.possible == nullptr && (is_open || status == CheckStatus::pass)) {
      result.possible = of_class.row;
    }
    if (status == CheckStatus::pass) {
      result.reached = of_class.row;
      break;
    }
  }
  return result;
}

}  // namespace rules
