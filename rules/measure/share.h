#pragma once
// The share of a plane's points whose value lies in a range.

#include "calc/base/field.h"
#include "rules/catalogue/metric_arguments.h"
#include "rules/measure/derived_points.h"
#include "rules/measure/metrics.h"

#include <cstdint>
#include <vector>

namespace rules {

struct ShareEstimate {
  calc::Estimate estimate;  // [0, 1]
  // [point]: 1 where the true value may be on either side of an end of the range.
  std::vector<std::uint8_t> open;
};

// Returns the share with its interval. All points have t-limits at a share of 1 - confidence each,
// so with `confidence` all true values are within their limits, whatever their correlation
// (Bonferroni). low: points whose limits are in the range; high: those that may be in it. A point
// reached by no sample, or resting on a single sample, is open. values.points >= 1, confidence in
// (0, 1).
ShareEstimate compute_share(const PointValues& values, const ValueRange& range, double confidence);
// Returns the share of derived points, at least one.
ShareEstimate compute_share(const DerivedPoints& points, const ValueRange& range,
                            double confidence);

}  // namespace rules
