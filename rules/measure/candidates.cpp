#include "rules/measure/candidates.h"

#include "rules/measure/replicate_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rules {
namespace {

using Marks = std::vector<std::uint8_t>;

// Returns the share of a single sample if it is too large to be trusted, else 0. Above 1 if a
// sample that could have been drawn is larger than the sum of all drawn ones.
double untrusted_share(const PointValues& values, std::size_t point) {
  if (values.largest_share.empty()) return 0.0;
  const float share = values.largest_share[point];
  return share > kLargestTrustedShare ? static_cast<double>(share) : 0.0;
}

// Marks points whose value may be as low as `bound`. A point that rests on one sample would,
// without it, be lower by that sample's share.
Marks low_points(const PointValues& values, LimitsOfPoint limits_of, double bound, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const double t = one_sided_t(values.replicates, alpha / 2.0);
  Marks marks(values.points, 0);
  for (std::size_t i = 0; i < values.points; ++i) {
    const double low = limits_of(all, i, t).low * std::max(0.0, 1.0 - untrusted_share(values, i));
    if (low <= bound) marks[i] = 1;
  }
  return marks;
}

// Marks points whose value may be as high as `bound`; points that no sample has reached may have
// any value.
Marks high_points(const PointValues& values, double bound, double alpha) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const double t = one_sided_t(values.replicates, alpha / 2.0);
  Marks marks(values.points, 0);
  for (std::size_t i = 0; i < values.points; ++i) {
    const double high = point_limits(all, i, t).high;
    // A second sample as large as the largest may be missing.
    if (values.is_unseen(i) || high * (1.0 + untrusted_share(values, i)) >= bound) marks[i] = 1;
  }
  return marks;
}

// Returns whether the average, times u, is the larger part of the noise of E_i - u * mean(E) at the
// worst of these points, which determines the lower limit of Uo.
bool average_is_noisier(const PointValues& values, const Marks& marks, double u) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  constexpr double kUsualT = 2.0;  // only ranks the points
  double worst = std::numeric_limits<double>::infinity();
  bool is_noisier = false;
  for (std::size_t i = 0; i < values.points; ++i) {
    if (marks[i] == 0) continue;
    const double of_average = u * u * all.plane_variance;
    const double variance = all.variance[i] - 2.0 * u * all.covariance[i] + of_average;
    const double low =
        all.mean_lx[i] - u * all.plane_mean_lx - kUsualT * std::sqrt(std::max(variance, 0.0));
    if (low >= worst) continue;
    worst = low;
    is_noisier = of_average > 0.5 * variance;
  }
  return is_noisier;
}

Marks united(Marks a, const Marks& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] | b[i];
  return a;
}

Candidates same_for_both(Marks marks) { return Candidates{marks, marks}; }

// Returns the bound below which points matter for a minimum: its upper limit, or the required limit
// if only that counts. Mirrored for a maximum.
double low_bound(const calc::Estimate& estimate, std::optional<double> limit) {
  return limit ? std::min(*limit, estimate.high) : estimate.high;
}
double high_bound(const calc::Estimate& estimate, std::optional<double> limit) {
  return limit ? std::max(*limit, estimate.low) : estimate.low;
}

// Marks the points of both extremes, each at half of the risk, as in the interval of Ud.
Marks extreme_points(const PointValues& values, double alpha) {
  const double confidence = 1.0 - alpha / 2.0;
  const auto bounds_of = [&](Metric metric) {
    return compute_metric(values, metric, 0.0, std::nullopt, confidence)->estimate;
  };
  return united(low_points(values, point_limits, bounds_of(Metric::minimum).high, alpha / 2.0),
                high_points(values, bounds_of(Metric::maximum).low, alpha / 2.0));
}

// Marks points of which one sample is too large a share of the plane's average. The illuminance of
// a single point averages out.
Marks average_spoilers(const PointValues& values) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const bool is_weighted = !values.weight.empty();
  const double weights = is_weighted
                             ? std::accumulate(values.weight.begin(), values.weight.end(), 0.0)
                             : static_cast<double>(values.points);
  const double sum_lx = all.plane_mean_lx * weights;
  Marks marks(values.points, 0);
  for (std::size_t i = 0; i < values.points; ++i) {
    const double weight = is_weighted ? values.weight[i] : 1.0;
    const double sample_lx = weight * untrusted_share(values, i) * all.mean_lx[i];
    if (sample_lx > static_cast<double>(kLargestTrustedShare) * sum_lx) marks[i] = 1;
  }
  return marks;
}

}  // namespace

Candidates find_candidates(const PointValues& values, Metric metric, double percent,
                           std::optional<std::size_t> point, const calc::Estimate& estimate,
                           std::optional<double> limit, double confidence) {
  const double alpha = 1.0 - confidence;
  switch (metric) {
    case Metric::average:
      return {average_spoilers(values), Marks(values.points, 1)};
    case Metric::percentile:
      if (percentile_rank(percent, values.points) == 1) {
        return find_candidates(values, Metric::minimum, 0.0, point, estimate, limit, confidence);
      }
      if (percentile_rank(percent, values.points) == values.points) {
        return find_candidates(values, Metric::maximum, 0.0, point, estimate, limit, confidence);
      }
      break;
    case Metric::minimum:
      return same_for_both(low_points(values, point_limits, low_bound(estimate, limit), alpha));
    case Metric::maximum:
      return same_for_both(high_points(values, high_bound(estimate, limit), alpha));
    case Metric::uniformity_min_avg: {
      Candidates found =
          same_for_both(united(low_points(values, ratio_limits, low_bound(estimate, limit), alpha),
                               average_spoilers(values)));
      if (average_is_noisier(values, found.active, limit.value_or(estimate.value))) {
        found.active.assign(values.points, 1);
      }
      return found;
    }
    case Metric::uniformity_min_max:
      return same_for_both(extreme_points(values, alpha));
    case Metric::value_at_point: {
      Marks marks(values.points, 0);
      marks[point.value()] = 1;
      return same_for_both(marks);
    }
    default:  // hangs on all points
      break;
  }
  return same_for_both(Marks(values.points, 1));
}

DoubtfulPoints count_doubtful(const PointValues& values, Metric metric, const Marks& matters) {
  DoubtfulPoints doubtful;
  std::size_t unseen = 0;
  for (std::size_t i = 0; i < values.points; ++i) {
    if (values.is_unseen(i)) ++unseen;
    if (matters[i] == 0) continue;
    if (values.is_unseen(i)) ++doubtful.unseen;
    if (!values.is_untrusted(i)) continue;
    ++doubtful.single_sample;
    doubtful.largest_share = std::max(doubtful.largest_share, values.largest_share[i]);
  }
  // The average does not hang on single points: unseen ones only matter if all of them are.
  if (metric == Metric::average) doubtful.unseen = unseen == values.points ? unseen : 0;
  return doubtful;
}

}  // namespace rules
