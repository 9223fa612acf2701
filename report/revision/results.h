#pragma once
// What became of what was judged: verdicts, and differences with intervals of their own.

#include "report/document/revision.h"
#include "rules/catalogue/aggregate.h"
#include "rules/verdict/judge.h"

#include <optional>

namespace report {

// after - before, the two taken for independent.
calc::Estimate difference_of(const calc::Estimate& before, const calc::Estimate& after);

// Of one requirement; one of the two may be null. confidence: two-sided level of the interval of a
// difference of replicates. place: of the requirement.
ChangedResult compare_results(const rules::Finding* before, const rules::Finding* after,
                              double confidence, const RevisionPlace& place);
// Of one aggregate, which has no value but that of a sum.
ChangedResult compare_results(const rules::AggregateFinding* before,
                              const rules::AggregateFinding* after, const RevisionPlace& place);

}  // namespace report
