#include "rules/verdict/members.h"

#include "rules/pack/evaluate.h"
#include "rules/verdict/outcome.h"

#include <algorithm>
#include <cstddef>

namespace rules {

Verdict verdict_of_both(Verdict a, Verdict b) {
  return a == Verdict::fail || b == Verdict::fail ? Verdict::fail : graver(a, b);
}

bool lacks_areas(const RuleAggregate& aggregate, const std::vector<AggregateMember>& members) {
  return aggregate.by_area &&
         std::any_of(members.begin(), members.end(),
                     [](const AggregateMember& member) { return !member.area_m2; });
}

bool lacks_members(const RuleAggregate& aggregate, const std::vector<AggregateMember>& members) {
  return aggregate.rule == AggregateRule::at_least && !members.empty() &&
         members.size() < static_cast<std::size_t>(aggregate.count);
}

std::optional<double> sum_of(const std::vector<AggregateMember>& members) {
  double area_m2 = 0.0, sum = 0.0;
  for (const AggregateMember& member : members) {
    if (!member.value || !member.area_m2) return std::nullopt;
    area_m2 += *member.area_m2;
    sum += *member.value * *member.area_m2;
  }
  return area_m2 > 0.0 ? std::optional(sum / area_m2) : std::nullopt;
}

std::optional<Verdict> combined_verdict(const RuleAggregate& aggregate,
                                        const std::vector<AggregateMember>& members) {
  std::vector<WeightedStatus> weighted;
  bool is_one_missing = false;
  for (const AggregateMember& member : members) {
    is_one_missing = is_one_missing || member.verdict == Verdict::not_judged;
    weighted.push_back(
        {status_of(member.verdict), aggregate.by_area ? member.area_m2.value_or(0.0) : 1.0});
  }
  RuleAggregate rule = aggregate;
  if (lacks_areas(aggregate, members)) {
    // What is the same for all is the same for any share of them.
    const bool all_fail = std::all_of(weighted.begin(), weighted.end(), [](const auto& member) {
      return member.status == CheckStatus::fail;
    });
    if (all_fail) return Verdict::fail;
    rule.rule = AggregateRule::all;
    return combine_statuses(rule, weighted) == CheckStatus::pass ? Verdict::pass
                                                                 : Verdict::not_judged;
  }
  // Of fewer than are needed nobody can say that they are not met.
  if (lacks_members(aggregate, members)) return Verdict::not_judged;
  switch (combine_statuses(rule, weighted)) {
    case CheckStatus::pass:
      return Verdict::pass;
    case CheckStatus::fail:
      return Verdict::fail;
    case CheckStatus::not_applicable:
      return std::nullopt;
    case CheckStatus::undecided:
    case CheckStatus::not_evaluated:
      break;
  }
  return is_one_missing ? Verdict::not_judged : Verdict::undecided;
}

}  // namespace rules
