#pragma once
// What the members of an aggregate come to together, from their verdicts alone: for those who
// judge, and for those who read what was judged.

#include "rules/catalogue/aggregate.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <vector>

namespace rules {

// As much as can be said of all of them together. Other than in a batch a member that fails comes
// before one that cannot be judged: whatever the latter is, not all of them are met.
Verdict verdict_of_both(Verdict a, Verdict b);

// Pass or fail only if it is so whatever the open members turn out to be. Of the aggregate only the
// rule, the count, the share and by_area are read; of the members verdicts and areas. Empty:
// nothing is required.
std::optional<Verdict> combined_verdict(const RuleAggregate& aggregate,
                                        const std::vector<AggregateMember>& members);

// Of a sum: what its members have for each square metre of all of their floors. Empty: of a member
// it is not known.
std::optional<double> sum_of(const std::vector<AggregateMember>& members);

// Members whose areas are needed, and one is not known; fewer members than must be met.
bool lacks_areas(const RuleAggregate& aggregate, const std::vector<AggregateMember>& members);
bool lacks_members(const RuleAggregate& aggregate, const std::vector<AggregateMember>& members);

}  // namespace rules
