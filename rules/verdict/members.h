#pragma once
// Combines the members of an aggregate, from their verdicts alone: for judging, and for readers of
// judged results.

#include "rules/catalogue/aggregate.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <vector>

namespace rules {

// Returns the verdict of both together. Unlike in a batch, a failing member outweighs one that
// cannot be judged: whatever that one is, not all members are met.
Verdict verdict_of_both(Verdict a, Verdict b);

// Returns pass or fail only if the open members cannot change it. Uses only rule, count, share and
// by_area of the aggregate, and verdicts and areas of the members. Empty: nothing is required.
std::optional<Verdict> combined_verdict(const RuleAggregate& aggregate,
                                        const std::vector<AggregateMember>& members);

// Returns the total of the members per square metre of all their floors. Empty: one is not known.
std::optional<double> sum_of(const std::vector<AggregateMember>& members);

// Return whether a needed area is not known, or there are fewer members than must be met.
bool lacks_areas(const RuleAggregate& aggregate, const std::vector<AggregateMember>& members);
bool lacks_members(const RuleAggregate& aggregate, const std::vector<AggregateMember>& members);

}  // namespace rules
