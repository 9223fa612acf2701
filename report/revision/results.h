#pragma once
// Compares results: verdicts, and differences with their own intervals.

#include "report/document/revision.h"
#include "rules/catalogue/aggregate.h"
#include "rules/verdict/judge.h"

#include <optional>

namespace report {

// Returns after - before, taken as independent.
calc::Estimate difference_of(const calc::Estimate& before, const calc::Estimate& after);

// Compares the results of a requirement; one of the two may be null. confidence: two-sided level of
// the interval of a difference of replicates. place: of the requirement.
ChangedResult compare_results(const rules::Finding* before, const rules::Finding* after,
                              double confidence, const RevisionPlace& place);
// Compares the results of an aggregate; only sums have a value.
ChangedResult compare_results(const rules::AggregateFinding* before,
                              const rules::AggregateFinding* after, const RevisionPlace& place);

}  // namespace report
