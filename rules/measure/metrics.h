#pragma once
// Statistics of a plane with confidence intervals, from independent replicates.

#include "calc/base/field.h"
#include "rules/catalogue/requirement.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rules {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Largest share of a point's value that a single sample may have. Above it the point is not
// trusted: its few large samples do not average, and its t-interval means little.
inline constexpr float kLargestTrustedShare = 0.1F;

// Illuminance of one plane in one light scene and state: value_lx[replicate * points + point].
// exact: one replicate that holds the true values.
struct PointValues {
  std::size_t points = 0;
  std::size_t replicates = 0;
  std::vector<double> value_lx;
  // The same from the sampling rounds with all points, for statistics over several points; see
  // calc::PlaneField. Empty: value_lx is.
  std::vector<double> even_lx = {};
  // [point]: 1 if sampled light may reach the point but no sample did: its 0 lx is no measurement.
  // May be empty.
  std::vector<std::uint8_t> unseen = {};
  // [point]: the largest single sample's share of the value, >= 0; see calc::PlaneField. May be
  // empty.
  std::vector<float> largest_share = {};
  // [point]: light that a single sample of reflected light adds to the value, lx, if it is large;
  // see calc::PlaneField::largest_sample_lx. Below 0 for mirrored values. May be empty.
  std::vector<double> largest_sample_lx = {};
  // [point]: weight in averages, > 0, in any unit. Empty: all alike.
  std::vector<double> weight = {};

  bool is_exact() const { return replicates == 1; }
  bool is_unseen(std::size_t point) const { return !unseen.empty() && unseen[point] != 0; }
  bool is_untrusted(std::size_t point) const {
    return !largest_share.empty() && largest_share[point] > kLargestTrustedShare;
  }
  double largest_sample_at(std::size_t point) const {
    return largest_sample_lx.empty() ? 0.0 : largest_sample_lx[point];
  }
  double at(std::size_t replicate, std::size_t point) const {
    return value_lx[replicate * points + point];
  }
  double even_at(std::size_t replicate, std::size_t point) const {
    return (even_lx.empty() ? value_lx : even_lx)[replicate * points + point];
  }
};

// Returns the weights of the field's channels in a scene and state. level_of_group: dimming levels;
// groups not named are at 1.
std::vector<double> channel_weights(
    const calc::PlaneField& field, LightState state,
    const std::vector<std::pair<std::string, double>>& level_of_group);

// direct: without reflected light.
enum class LightParts { all, direct };

// Returns the sum over the field's channels with those weights.
PointValues combine_channels(const calc::PlaneField& field, LightState state,
                             const std::vector<std::pair<std::string, double>>& level_of_group,
                             LightParts parts = LightParts::all);

// Returns the values of these points only, in their order.
PointValues select_points(const PointValues& values, const std::vector<std::size_t>& points);

// confidence = 1 - alpha in (0, 1), e.g. 0.95: two-sided level of every interval below. The
// intervals assume that replicates are independent and normally distributed, except for large
// single samples that may be missing (LargeSample); points may be correlated in any way. Limits
// outside the range of the quantity (below 0 lx, above a ratio of 1) are moved to the end of the
// range.

// Returns the Student-t interval of each point.  [METHOD, 7.1]
std::vector<calc::Estimate> point_estimates(const PointValues& values, double confidence);

// A statistic with its interval, and the point that attains it: for the minimum, the maximum, the
// value at a point, and the minimum of a uniformity.
struct MetricEstimate {
  calc::Estimate estimate;
  std::optional<std::size_t> point;
};

// Returns the 1-based rank of the percentile among the point values in ascending order; see below.
std::size_t percentile_rank(double percent, std::size_t points);

// Returns a statistic with its interval. percent: for Metric::percentile, [0, 100]; the percentile
// is the smallest point value that at least `percent` % of the points do not exceed, so 0 is the
// minimum and 100 the maximum. point: for Metric::value_at_point. values.points >= 1. Empty for a
// uniformity whose denominator, average or maximum, is 0.
std::optional<MetricEstimate> compute_metric(const PointValues& values, Metric metric,
                                             double percent, std::optional<std::size_t> point,
                                             double confidence);

}  // namespace rules
