#include "rules/measure/despite_doubt.h"

#include "rules/catalogue/compare.h"
#include "rules/measure/replicate_sample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rules {
namespace {

struct KnownPoint {
  std::size_t point;
  Limits limits;
};

// Returns t for limits of single points that hold together at half the risk.
double t_for_all(std::size_t points, std::size_t replicates, double alpha) {
  return one_sided_t(replicates, 0.5 * alpha / static_cast<double>(points));
}

// Returns the estimate of the value of a rank: at least `rank` points have at most `high`, so the
// value of that rank among all points is at most `high`, too. least: lower bound of all values.
std::optional<MetricEstimate> nth_from_below(std::vector<KnownPoint> known, std::size_t rank,
                                             double least) {
  if (rank == 0 || known.size() < rank) return std::nullopt;
  const auto nth = known.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(known.begin(), nth, known.end(), [](const KnownPoint& a, const KnownPoint& b) {
    return a.limits.high < b.limits.high;
  });
  const double high = nth->limits.high;
  std::nth_element(known.begin(), nth, known.end(), [](const KnownPoint& a, const KnownPoint& b) {
    return a.limits.value != b.limits.value ? a.limits.value < b.limits.value : a.point < b.point;
  });
  const double value = nth->limits.value;
  return MetricEstimate{{value, std::min(least, value), std::max(high, value)}, nth->point};
}

// Returns the mirror image; rank from the largest.
std::optional<MetricEstimate> nth_from_above(std::vector<KnownPoint> known, std::size_t rank) {
  for (KnownPoint& one : known) {
    one.limits = {-one.limits.high, -one.limits.value, -one.limits.low};
  }
  std::optional<MetricEstimate> result = nth_from_below(std::move(known), rank, -kInfinity);
  if (!result) return std::nullopt;
  const calc::Estimate& mirrored = result->estimate;
  result->estimate = {-mirrored.value, -mirrored.high, -mirrored.low};
  return result;
}

// Returns the rank among `count` points, from the smallest; 0: the metric is not a rank.
std::size_t rank_in(const Requirement& requirement, std::size_t count) {
  switch (requirement.metric) {
    case Metric::minimum:
      return 1;
    case Metric::maximum:
    case Metric::gradient:
      return count;
    case Metric::percentile:
      return percentile_rank(argument_of<Percentile>(requirement).percent, count);
    default:
      return 0;
  }
}

std::optional<MetricEstimate> known_rank(std::vector<KnownPoint> known,
                                         const Requirement& requirement, std::size_t count,
                                         double least) {
  const std::size_t rank = rank_in(requirement, count);
  if (rank == 0) return std::nullopt;
  std::optional<MetricEstimate> result = is_lower_limit(requirement.comparison)
                                             ? nth_from_below(std::move(known), rank, least)
                                             : nth_from_above(std::move(known), count - rank + 1);
  if (result && requirement.metric == Metric::percentile) result->point.reset();
  return result;
}

bool is_unknown(const PointValues& values, std::size_t point) {
  return values.is_unseen(point) || values.is_untrusted(point);
}

// Returns the values as if no light reached the doubtful points: a lower bound of the average.
PointValues darkened(PointValues values) {
  for (std::size_t i = 0; i < values.points; ++i) {
    if (!is_unknown(values, i)) continue;
    for (std::size_t r = 0; r < values.replicates; ++r) {
      values.value_lx[r * values.points + i] = 0.0;
      if (!values.even_lx.empty()) values.even_lx[r * values.points + i] = 0.0;
    }
    if (!values.largest_sample_lx.empty()) values.largest_sample_lx[i] = 0.0;
  }
  return values;
}

template <class LimitsOf>
std::vector<KnownPoint> known_points(const PointValues& values, const LimitsOf& limits_of) {
  std::vector<KnownPoint> known;
  for (std::size_t i = 0; i < values.points; ++i) {
    if (!is_unknown(values, i)) known.push_back({i, limits_of(i)});
  }
  return known;
}

std::vector<KnownPoint> known_values(const PointValues& values, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const double t = t_for_all(values.points, values.replicates, alpha);
  return known_points(values, [&](std::size_t i) { return point_limits(all, i, t); });
}

// Returns the average for upper limits only.
std::optional<MetricEstimate> known_average(const PointValues& values, double alpha) {
  const ReplicateSample dark = summarize(darkened(values), 0, values.replicates);
  const double value = summarize(values, 0, values.replicates).plane_mean_lx;
  const double low = plane_limits(dark, one_sided_t(values.replicates, 0.5 * alpha)).low;
  return MetricEstimate{{value, std::min(low, value), kInfinity}, std::nullopt};
}

// Returns Uo for lower limits only. A smaller average makes the ratio larger.
std::optional<MetricEstimate> known_uo(const PointValues& values, double alpha) {
  const double plane_lx = summarize(values, 0, values.replicates).plane_mean_lx;
  if (!(plane_lx > 0.0)) return std::nullopt;
  const ReplicateSample dark = summarize(darkened(values), 0, values.replicates);
  const double t = t_for_all(values.points, values.replicates, alpha);
  return nth_from_below(known_points(values,
                                     [&](std::size_t i) {
                                       const double high = ratio_limits(dark, i, t).high;
                                       return Limits{0.0, dark.mean_lx[i] / plane_lx, high};
                                     }),
                        1, 0.0);
}

// Returns Ud, each extreme at half the risk, as in its interval.
std::optional<MetricEstimate> known_ud(const PointValues& values, double alpha) {
  const std::vector<KnownPoint> known = known_values(values, 0.5 * alpha);
  std::optional<MetricEstimate> result = nth_from_below(known, 1, 0.0);
  const std::optional<MetricEstimate> largest = nth_from_above(known, 1);
  if (!result || !(largest->estimate.low > 0.0)) return std::nullopt;
  const calc::Estimate smallest = result->estimate;
  result->estimate = {smallest.value / largest->estimate.value, 0.0,
                      smallest.high / largest->estimate.low};
  return result;
}

}  // namespace

std::optional<MetricEstimate> despite_doubt(const PointValues& values,
                                            const Requirement& requirement, double confidence) {
  const double alpha = 1.0 - confidence;
  const bool is_lower = is_lower_limit(requirement.comparison);
  switch (requirement.metric) {
    case Metric::average:
      return is_lower ? std::nullopt : known_average(values, alpha);
    case Metric::uniformity_min_avg:
      return is_lower ? known_uo(values, alpha) : std::nullopt;
    case Metric::uniformity_min_max:
      return is_lower ? known_ud(values, alpha) : std::nullopt;
    case Metric::minimum:
    case Metric::maximum:
    case Metric::percentile:
      return known_rank(known_values(values, alpha), requirement, values.points, 0.0);
    default:
      return std::nullopt;
  }
}

std::optional<MetricEstimate> despite_doubt(const DerivedPoints& points,
                                            const Requirement& requirement, double confidence) {
  const double t = t_for_all(points.points(), points.replicates(), 1.0 - confidence);
  std::vector<KnownPoint> known;
  std::size_t count = 0;  // that have a value, or may have one
  for (std::size_t i = 0; i < points.points(); ++i) {
    const Limits limits = points.limits(i, t);
    if (!(limits.high > -kInfinity)) continue;
    ++count;
    if (!points.is_doubtful(i) && std::isfinite(limits.value)) known.push_back({i, limits});
  }
  return known_rank(std::move(known), requirement, count, 0.0);
}

}  // namespace rules
