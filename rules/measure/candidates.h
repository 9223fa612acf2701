#pragma once
// Which points a quantity hangs on: where more samples can move its interval, and where a value
// that cannot be trusted would spoil it.

#include "rules/catalogue/requirement.h"
#include "rules/measure/metrics.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rules {

// Candidates of one quantity. Both have one mark (0 or 1) per point.
struct Candidates {
  // 1: the quantity hangs on this point's own value. E.g. of a minimum, where the lower limit of
  // the point is not above the minimum's upper limit; of an average, where a single sample of the
  // point is a large share of the average.
  std::vector<std::uint8_t> matters;
  // 1: worth more samples.
  std::vector<std::uint8_t> active;
};

// limit: only the side of this limit on which the quantity lies is of interest; empty: its whole
// interval is. estimate: what compute_metric() gave for the same arguments.
Candidates find_candidates(const PointValues& values, Metric metric, double percent,
                           std::optional<std::size_t> point, const calc::Estimate& estimate,
                           std::optional<double> limit, double confidence);

// Points that matter for the quantity and whose value is not known to be what was measured.
struct DoubtfulPoints {
  std::size_t unseen = 0;         // sampled light may reach them, but no sample has
  std::size_t single_sample = 0;  // they rest on single samples
  float largest_share = 0.0F;     // of those
};
DoubtfulPoints count_doubtful(const PointValues& values, Metric metric,
                              const std::vector<std::uint8_t>& matters);

}  // namespace rules
