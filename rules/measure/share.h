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
  // [point]: 1 where it is open on which side of an end the true value lies.
  std::vector<std::uint8_t> open;
};

// All points have t-limits at a share of 1 - confidence each, so that with `confidence` all true
// values are within theirs, whatever their correlation (Bonferroni); low: the points whose limits
// are in the range; high: those that may be. A point that no sample has reached, or that rests on a
// single one, is open. values.points >= 1, confidence in (0, 1).
ShareEstimate compute_share(const PointValues& values, const ValueRange& range, double confidence);
// The same of derived points, at least one.
ShareEstimate compute_share(const DerivedPoints& points, const ValueRange& range,
                            double confidence);

}  // namespace rules
