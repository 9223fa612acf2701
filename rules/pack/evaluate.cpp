#include "rules/pack/evaluate.h"

#include "calc/base/sentences.h"

#include <fmt/format.h>

#include <algorithm>

namespace rules {
namespace {

std::optional<calc::Estimate> measured_for(const RuleCheck& check, const Evidence& evidence) {
  const auto found = evidence.measured.find(check.id);
  if (found == evidence.measured.end()) return std::nullopt;
  return found->second;
}

CheckResult without_verdict(CheckResult result, CheckStatus status, calc::Message reason) {
  result.status = status;
  result.reason = std::move(reason);
  return result;
}

// Weights of what passes for certain, and of all that may pass.
struct Tally {
  double all = 0.0, certain = 0.0, possible = 0.0;
};

Tally tally_of(const std::vector<WeightedStatus>& members, bool counts_weights) {
  Tally tally;
  for (const WeightedStatus& member : members) {
    if (member.status == CheckStatus::not_applicable) continue;
    const double weight = counts_weights ? member.weight : 1.0;
    tally.all += weight;
    if (member.status == CheckStatus::pass) tally.certain += weight;
    if (member.status != CheckStatus::fail) tally.possible += weight;
  }
  return tally;
}

double needed(const RuleAggregate& aggregate, double all) {
  switch (aggregate.rule) {
    case AggregateRule::all:
      return all;
    case AggregateRule::any:
      return 1.0;
    case AggregateRule::at_least:
      return aggregate.count;
    case AggregateRule::share:
      return aggregate.share * all;
    case AggregateRule::sum:
      break;
  }
  return all;
}

}  // namespace

CheckStatus status_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return CheckStatus::pass;
    case Verdict::fail:
      return CheckStatus::fail;
    case Verdict::undecided:
      return CheckStatus::undecided;
    case Verdict::not_judged:
      break;
  }
  return CheckStatus::not_evaluated;
}

const char* status_name(CheckStatus status) {
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

CheckResult evaluate_check(const RuleCheck& check, const Evidence& evidence) {
  CheckResult result;
  result.check = &check;
  result.limit =
      evaluate_limit(check, {evidence.pack, evidence.row, evidence.level, evidence.facts,
                             [&](const RuleCheck& other) { return measured_for(other, evidence); },
                             evidence.special});
  if (result.limit.status == LimitStatus::not_applicable) {
    return without_verdict(result, CheckStatus::not_applicable, result.limit.reason);
  }
  if (result.limit.status == LimitStatus::unknown) {
    return without_verdict(result, CheckStatus::not_evaluated, result.limit.reason);
  }
  result.measured = measured_for(check, evidence);
  if (!result.measured) {
    return without_verdict(result, CheckStatus::not_evaluated,
                           calc::say<calc::Sentence::no_result_for_it>());
  }
  const DecisionPolicy& policy = evidence.pack.policy;
  const int digits = policy.digits(check.dimension(), is_ratio(check.metric));
  const Decision decision =
      decide({*result.measured, check.comparison, result.limit.value, digits}, policy);
  result.status = status_of(decision.verdict);
  result.is_close = decision.is_close;
  result.by_tolerance = decision.by_tolerance;
  return result;
}

CheckStatus combine_statuses(const RuleAggregate& aggregate,
                             const std::vector<WeightedStatus>& members) {
  const Tally tally = tally_of(members, aggregate.rule == AggregateRule::share);
  if (!(tally.all > 0.0)) return CheckStatus::not_applicable;
  // Shares of areas are sums of rounded numbers.
  constexpr double kBinaryNoise = 1e-9;
  const double wanted = needed(aggregate, tally.all) * (1.0 - kBinaryNoise);
  if (tally.certain >= wanted) return CheckStatus::pass;
  return tally.possible >= wanted ? CheckStatus::undecided : CheckStatus::fail;
}

CheckStatus evaluate_aggregate(const RuleAggregate& aggregate, const Evidence& evidence) {
  std::vector<WeightedStatus> members;
  for (const std::string& id : aggregate.checks) {
    members.push_back({evaluate_check(*evidence.pack.find_check(id), evidence).status, 1.0});
  }
  return combine_statuses(aggregate, members);
}

ClassResult evaluate_class(const RuleClass& item, const Evidence& evidence) {
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
