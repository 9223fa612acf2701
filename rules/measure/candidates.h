#pragma once
// Finds the points on which a quantity depends: where more samples can move its interval, and where
// an unreliable value would spoil it.

#include "rules/catalogue/requirement.h"
#include "rules/measure/metrics.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rules {

// Candidates of one quantity. Both vectors have one mark (0 or 1) per point.
struct Candidates {
  // 1: the quantity depends on this point's own value. Examples: for a minimum, the lower limit of
  // the point is not above the minimum's upper limit; for an average, a single sample of the point
  // is a large share of the average.
  std::vector<std::uint8_t> matters;
  // 1: worth more samples.
  std::vector<std::uint8_t> active;
};

// Returns the candidates of a quantity. limit: only the side of this limit where the quantity lies
// counts; empty: its whole interval does. estimate: result of compute_metric() for the same
// arguments.
Candidates find_candidates(const PointValues& values, Metric metric, double percent,
                           std::optional<std::size_t> point, const calc::Estimate& estimate,
                           std::optional<double> limit, double confidence);

// Points that matter for the quantity and whose measured value is not reliable.
struct DoubtfulPoints {
  std::size_t unseen = 0;         // sampled light may reach them, but no sample has
  std::size_t single_sample = 0;  // they rest on single samples
  float largest_share = 0.0F;     // of those
};
DoubtfulPoints count_doubtful(const PointValues& values, Metric metric,
                              const std::vector<std::uint8_t>& matters);

}  // namespace rules
