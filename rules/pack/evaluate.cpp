#include "rules/pack/evaluate.h"

#include "rules/pack/limit.h"

#include <optional>

namespace rules {
namespace {

std::optional<calc::Estimate> measured_for(const RuleCheck& check, const Evidence& evidence) {
  const auto found = evidence.measured.find(check.id);
  if (found == evidence.measured.end()) return std::nullopt;
  return found->second;
}

// Weights of members that surely pass, and of all that may pass.
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

CheckStatus evaluate_check(const RuleCheck& check, const Evidence& evidence) {
  const Limit limit =
      evaluate_limit(check, {evidence.pack, evidence.row, evidence.level, evidence.facts,
                             [&](const RuleCheck& other) { return measured_for(other, evidence); },
                             evidence.special});
  if (limit.status == LimitStatus::not_applicable) return CheckStatus::not_applicable;
  const std::optional<calc::Estimate> measured = measured_for(check, evidence);
  if (limit.status == LimitStatus::unknown || !measured) return CheckStatus::not_evaluated;
  const DecisionPolicy& policy = evidence.pack.policy;
  const int digits = policy.digits(check.dimension(), is_ratio(check.metric));
  return status_of(decide({*measured, check.comparison, limit.value, digits}, policy).verdict);
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

}  // namespace rules
