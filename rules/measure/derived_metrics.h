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
  std::size_t unseen_points = 0, single_sample_points = 0;  // among those that the value hangs on
};

// Minimum, maximum, percentile, value (point: which) or share (range) with an interval at the
// two-sided level `confidence`, from limits of single points:
//   maximum, high: the largest upper limit, each at alpha / 2: no share for multiplicity is needed,
//   the true maximum belongs to one point. Low: the largest lower limit, at alpha / 2 shared by all
//   points, since any of them may have been chosen. Minimum mirrored. Percentile and share as of
//   illuminances (metrics.cpp, share.h).
// Points without a value (-infinity) are left out of all but shares. Empty if none has one.
// limit: only the side of it counts for `active`; empty: the whole interval does.
std::optional<DerivedEstimate> compute_derived(const DerivedPoints& points,
                                               const Requirement& requirement,
                                               std::optional<std::size_t> point,
                                               std::optional<double> limit, double confidence);

// Of a plane of ugr or modelling, in a state and with levels as combine_channels() takes them, at
// these points of its grid. receivers: what combine_channels() gave.
std::unique_ptr<DerivedPoints> make_derived_points(calc::DerivedQuantity derived,
                                                   const calc::PlaneField& field,
                                                   const PointValues& receivers,
                                                   const std::vector<double>& channel_weights,
                                                   const std::vector<std::size_t>& points);

}  // namespace rules
