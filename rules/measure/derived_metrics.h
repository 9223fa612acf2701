#pragma once
// Statistics of points whose quantity is more than one illuminance, with their intervals.

#include "rules/catalogue/requirement.h"
#include "rules/measure/derived_points.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rules {

struct DerivedEstimate {
  calc::Estimate estimate;  // the ends may be infinite
  std::optional<std::size_t> point;
  std::vector<std::uint8_t> active;  // [point]: 1 where more samples can move the interval
  std::size_t unseen_points = 0, single_sample_points = 0;  // of those that the value depends on
};

// Returns the minimum, maximum, percentile, value (point: which) or share (range), with an interval
// at the two-sided level `confidence` from limits of single points:
//   maximum, high: the largest upper limit, each at alpha / 2: no share for multiplicity is needed,
//   because the true maximum belongs to one point. Low: the largest lower limit, at alpha / 2
//   shared by all points, because any of them may have been chosen. Minimum mirrored. Percentile
//   and share as for illuminances (metrics.cpp, share.h).
// Points without a value (-infinity) count only in shares. Empty if no point has a value. limit:
// only its side counts for `active`; empty: the whole interval does.
std::optional<DerivedEstimate> compute_derived(const DerivedPoints& points,
                                               const Requirement& requirement,
                                               std::optional<std::size_t> point,
                                               std::optional<double> limit, double confidence);

// Returns the points of a plane of ugr or modelling, in a state and with levels as in
// combine_channels(), at these points of its grid. receivers: result of combine_channels().
std::unique_ptr<DerivedPoints> make_derived_points(calc::DerivedQuantity derived,
                                                   const calc::PlaneField& field,
                                                   const PointValues& receivers,
                                                   const std::vector<double>& channel_weights,
                                                   const std::vector<std::size_t>& points);

}  // namespace rules
