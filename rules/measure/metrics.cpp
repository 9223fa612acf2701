#include "rules/measure/metrics.h"

#include "calc/base/statistics.h"
#include "rules/measure/replicate_sample.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rules {
namespace {

// Moves limits into the possible range, and only here: illuminance is never negative, minimum /
// average and minimum / maximum are between 0 and 1, so the part of an interval beyond these ends
// holds no possible value and coverage is kept.
calc::Estimate within_range(const calc::Estimate& estimate, Metric metric) {
  const double largest = is_ratio(metric) ? 1.0 : estimate.high;
  calc::Estimate result;
  result.value =
      std::min(estimate.value, largest);  // min / average of equal values may round to 1 + 2e-16
  result.low = std::min(std::max(estimate.low, 0.0), result.value);
  result.high = std::max(std::min(estimate.high, largest), result.value);
  return result;
}

PointValues negated(PointValues values) {
  for (double& value : values.value_lx) value = -value;
  for (double& value : values.even_lx) value = -value;
  for (double& sample : values.largest_sample_lx) sample = -sample;
  return values;
}

calc::Estimate mirrored(const calc::Estimate& estimate) {
  return calc::Estimate{-estimate.value, -estimate.high, -estimate.low};
}

std::size_t darkest_point(const ReplicateSample& sample) {
  const auto smallest = std::min_element(sample.mean_lx.begin(), sample.mean_lx.end());
  return static_cast<std::size_t>(smallest - sample.mean_lx.begin());
}

double smallest_low(const ReplicateSample& sample, LimitsOfPoint limits_of, double t) {
  double low = limits_of(sample, 0, t).low;
  for (std::size_t i = 1; i < sample.mean_lx.size(); ++i) {
    low = std::min(low, limits_of(sample, i, t).low);
  }
  return low;
}

double smallest_high(const ReplicateSample& sample, LimitsOfPoint limits_of, double t) {
  double high = limits_of(sample, 0, t).high;
  for (std::size_t i = 1; i < sample.mean_lx.size(); ++i) {
    high = std::min(high, limits_of(sample, i, t).high);
  }
  return high;
}

// Upper limit, at `level`, of the smallest q_i. The upper limit of any one point i serves, provided
// that i was not chosen by the replicates that give the limit. Two valid ways:
//   all points are candidates and share the level (Bonferroni), or
//   each half of the replicates names its darkest point and the other half limits it, at level / 2
//   each.
// The first needs a larger t, the second has half the replicates; the smaller factor of the
// standard error is taken. It depends on the numbers of points and replicates only, so that the
// choice is not a look at the data.
double upper_limit(const PointValues& values, const ReplicateSample& all, LimitsOfPoint limits_of,
                   double level) {
  const std::size_t half_a = values.replicates / 2;
  const std::size_t half_b = values.replicates - half_a;
  const double t_shared =
      one_sided_t(values.replicates, level / static_cast<double>(values.points));
  const bool can_be_halved = half_a >= 2;
  const double t_a = can_be_halved ? one_sided_t(half_a, level / 2.0) : 0.0;
  if (!can_be_halved || t_shared <= t_a * std::numbers::sqrt2) {
    return smallest_high(all, limits_of, t_shared);
  }
  const double t_b = one_sided_t(half_b, level / 2.0);
  const ReplicateSample a = summarize(values, 0, half_a);
  const ReplicateSample b = summarize(values, half_a, half_b);
  return std::min(limits_of(b, darkest_point(a), t_b).high,
                  limits_of(a, darkest_point(b), t_a).high);
}

// Returns the interval of the smallest q_i over the points. Low: min_i L_i with every L_i at alpha
// / 2 on its own. No share for multiplicity is needed: the true smallest value is q_i* >= L_i* >=
// min L with probability 1 - alpha / 2, whichever point i* is. High: see upper_limit. The value,
// the smallest of noisy means, is biased low and may, rarely, be above that limit; the interval is
// then widened to it, which can only add coverage.
MetricEstimate smallest(const PointValues& values, LimitsOfPoint limits_of, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const std::size_t point = darkest_point(all);
  const double value = limits_of(all, point, 0.0).value;
  if (values.is_exact()) return MetricEstimate{{value, value, value}, point};
  const double low = smallest_low(all, limits_of, one_sided_t(values.replicates, alpha / 2.0));
  const double high = upper_limit(values, all, limits_of, alpha / 2.0);
  return MetricEstimate{{value, std::min(low, value), std::max(high, value)}, point};
}

MetricEstimate minimum(const PointValues& values, double alpha) {
  return smallest(values, point_limits, alpha);
}

// Returns the mirror image: the maximum of E is minus the minimum of -E.
MetricEstimate maximum(const PointValues& values, double alpha) {
  MetricEstimate result = minimum(negated(values), alpha);
  result.estimate = mirrored(result.estimate);
  return result;
}

// Returns Uo. Uo >= u if and only if every D_i(u) = E_i - u * mean(E) is >= 0. D_i is linear, so
// each has a t-limit, and "every lower limit is >= 0" needs no share for multiplicity
// (intersection-union test). The interval's low end is the largest u that passes this test.
// [METHOD, 7.3]
std::optional<MetricEstimate> uniformity_min_avg(const PointValues& values, double alpha) {
  if (!(calc::replicate_mean(plane_means(values)).mean > 0.0)) return std::nullopt;
  return smallest(values, ratio_limits, alpha);
}

// Returns Ud. Both ends combine a limit of the minimum with a limit of the maximum, at alpha / 4
// each: conservative, because errors of the two are treated as if they always added up.
std::optional<MetricEstimate> uniformity_min_max(const PointValues& values, double alpha) {
  const MetricEstimate smallest_e = minimum(values, alpha / 2.0);
  const calc::Estimate largest_e = maximum(values, alpha / 2.0).estimate;
  const calc::Estimate& min = smallest_e.estimate;
  if (!(largest_e.value > 0.0)) return std::nullopt;
  const double high = largest_e.low > 0.0 ? min.high / largest_e.low : 1.0;
  return MetricEstimate{{min.value / largest_e.value, min.low / largest_e.high, high},
                        smallest_e.point};
}

double order_statistic(std::vector<double> values, std::size_t rank) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

// Returns the value of rank k of M. Low: the k-th smallest of the points' lower limits. It exceeds
// the true percentile only if one of the k points that are truly at or below it has its limit above
// its own true value, so each limit gets the share alpha / 2 / k. High: mirrored, with the M - k +
// 1 points at or above it.
calc::Estimate ranked(const PointValues& values, std::size_t rank, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const double value = order_statistic(all.mean_lx, rank);
  if (values.is_exact()) return calc::Estimate{value, value, value};
  const double t_low = one_sided_t(all.replicates, alpha / 2.0 / static_cast<double>(rank));
  const double t_high =
      one_sided_t(all.replicates, alpha / 2.0 / static_cast<double>(values.points - rank + 1));
  std::vector<double> low;
  std::vector<double> high;
  for (std::size_t i = 0; i < values.points; ++i) {
    low.push_back(point_limits(all, i, t_low).low);
    high.push_back(point_limits(all, i, t_high).high);
  }
  return calc::Estimate{value, order_statistic(low, rank), order_statistic(high, rank)};
}

// Returns the percentile; its ends are the minimum and the maximum, with their (narrower)
// intervals.
calc::Estimate percentile(const PointValues& values, double percent, double alpha) {
  const std::size_t rank = percentile_rank(percent, values.points);
  if (rank == 1) return minimum(values, alpha).estimate;
  if (rank == values.points) return maximum(values, alpha).estimate;
  return ranked(values, rank, alpha);
}

calc::Estimate interval_of(const Limits& limits) {
  return calc::Estimate{limits.value, limits.low, limits.high};
}

calc::Estimate value_at(const PointValues& values, std::size_t point, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  return interval_of(point_limits(all, point, one_sided_t(values.replicates, alpha / 2.0)));
}

calc::Estimate average(const PointValues& values, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  return interval_of(plane_limits(all, one_sided_t(values.replicates, alpha / 2.0)));
}

std::optional<MetricEstimate> unbounded_metric(const PointValues& values, Metric metric,
                                               double percent, std::optional<std::size_t> point,
                                               double confidence) {
  const double alpha = 1.0 - confidence;
  switch (metric) {
    case Metric::average:
      return MetricEstimate{average(values, alpha), std::nullopt};
    case Metric::minimum:
      return minimum(values, alpha);
    case Metric::maximum:
      return maximum(values, alpha);
    case Metric::uniformity_min_avg:
      return uniformity_min_avg(values, alpha);
    case Metric::uniformity_min_max:
      return uniformity_min_max(values, alpha);
    case Metric::percentile:
      return MetricEstimate{percentile(values, percent, alpha), std::nullopt};
    case Metric::value_at_point:
      return MetricEstimate{value_at(values, point.value(), alpha), point};
    default:  // not from values alone, see MetricSource and measure.cpp
      break;
  }
  return std::nullopt;
}

}  // namespace

// Returns the rank. The tolerance absorbs binary noise in percent * points / 100.
std::size_t percentile_rank(double percent, std::size_t points) {
  const double share = percent * static_cast<double>(points) / 100.0;
  const double rank = std::ceil(share - 1e-9 * std::max(share, 1.0));
  return static_cast<std::size_t>(std::clamp(rank, 1.0, static_cast<double>(points)));
}

std::vector<calc::Estimate> point_estimates(const PointValues& values, double confidence) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const double t = one_sided_t(all.replicates, 0.5 * (1.0 - confidence));
  std::vector<calc::Estimate> estimates;
  estimates.reserve(values.points);
  for (std::size_t i = 0; i < values.points; ++i) {
    const Limits limits = point_limits(all, i, t);
    estimates.push_back(
        within_range({limits.value, limits.low, limits.high}, Metric::value_at_point));
  }
  return estimates;
}

std::optional<MetricEstimate> compute_metric(const PointValues& values, Metric metric,
                                             double percent, std::optional<std::size_t> point,
                                             double confidence) {
  std::optional<MetricEstimate> result =
      unbounded_metric(values, metric, percent, point, confidence);
  if (result) result->estimate = within_range(result->estimate, metric);
  return result;
}

}  // namespace rules
