#include "rules/measure/derived_metrics.h"

#include "rules/measure/share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rules {
namespace {

using Indices = std::vector<std::size_t>;

// Returns the points that have a value, or may have one.
Indices existing(const DerivedPoints& points) {
  Indices indices;
  for (std::size_t i = 0; i < points.points(); ++i) {
    if (points.limits(i, 0.0).high > -kInfinity) indices.push_back(i);
  }
  return indices;
}

double nth(std::vector<double> values, std::size_t rank) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

// Returns the value of rank k (1-based, ascending) of M. Low: none of the k points that are truly
// at or below it may have a lower limit beyond its own value, so they share alpha / 2; for the
// largest only that one point matters for the high end, for the smallest for the low end.
DerivedEstimate ranked(const DerivedPoints& points, const Indices& indices, std::size_t rank,
                       double alpha) {
  const std::size_t count = indices.size();
  const auto level_of = [&](std::size_t sharers) {
    return one_sided_t(points.replicates(), 0.5 * alpha / static_cast<double>(sharers));
  };
  const double t_low = level_of(rank), t_high = level_of(count - rank + 1);
  std::vector<double> low, value, high;
  for (const std::size_t i : indices) {
    low.push_back(points.limits(i, t_low).low);
    value.push_back(points.limits(i, 0.0).value);
    high.push_back(points.limits(i, t_high).high);
  }
  DerivedEstimate result;
  result.estimate.value = nth(value, rank);
  result.estimate.low = std::min(nth(low, rank), result.estimate.value);
  result.estimate.high = std::max(nth(high, rank), result.estimate.value);
  const auto found = std::find(value.begin(), value.end(), result.estimate.value);
  result.point = indices[static_cast<std::size_t>(found - value.begin())];
  return result;
}

// Marks points that may be on the wrong side of the relevant bound: for a maximum, above `limit`
// or, without it, above the maximum's own lower end.
void mark_candidates(const DerivedPoints& points, const Indices& indices, Metric metric,
                     std::optional<double> limit, double alpha, DerivedEstimate& result) {
  const double t = one_sided_t(points.replicates(), 0.5 * alpha);
  const calc::Estimate& of = result.estimate;
  result.active.assign(points.points(), 0);
  for (const std::size_t i : indices) {
    const Limits limits = points.limits(i, t);
    bool matters = true;
    if (metric == Metric::maximum) {
      matters = points.is_doubtful(i) || limits.high >= (limit ? std::max(*limit, of.low) : of.low);
    } else if (metric == Metric::minimum) {
      matters =
          points.is_doubtful(i) || limits.low <= (limit ? std::min(*limit, of.high) : of.high);
    } else if (metric == Metric::value_at_point) {
      matters = result.point == i;
    }
    if (!matters) continue;
    result.active[i] = 1;
    result.unseen_points += points.is_unseen(i) ? 1 : 0;
    result.single_sample_points += points.rests_on_one_sample(i) ? 1 : 0;
  }
}

std::size_t rank_of(const Requirement& requirement, std::size_t count) {
  if (requirement.metric == Metric::minimum) return 1;
  if (requirement.metric == Metric::maximum) return count;
  return percentile_rank(argument_of<Percentile>(requirement).percent, count);
}

}  // namespace

std::optional<DerivedEstimate> compute_derived(const DerivedPoints& points,
                                               const Requirement& requirement,
                                               std::optional<std::size_t> point,
                                               std::optional<double> limit, double confidence) {
  const double alpha = 1.0 - confidence;
  if (requirement.metric == Metric::share) {
    const ShareEstimate share =
        compute_share(points, argument_of<ValueRange>(requirement), confidence);
    return DerivedEstimate{share.estimate, std::nullopt, share.open, 0, 0};
  }
  Indices indices = existing(points);
  if (requirement.metric == Metric::value_at_point) {
    std::erase_if(indices, [&](std::size_t i) { return i != point; });
  }
  if (indices.empty()) return std::nullopt;
  const std::size_t rank =
      requirement.metric == Metric::value_at_point ? 1 : rank_of(requirement, indices.size());
  DerivedEstimate result = ranked(points, indices, rank, alpha);
  if (requirement.metric == Metric::percentile) result.point.reset();
  mark_candidates(points, indices, requirement.metric, limit, alpha, result);
  return result;
}

std::unique_ptr<DerivedPoints> make_derived_points(calc::DerivedQuantity derived,
                                                   const calc::PlaneField& field,
                                                   const PointValues& receivers,
                                                   const std::vector<double>& channel_weights,
                                                   const std::vector<std::size_t>& points) {
  if (derived == calc::DerivedQuantity::modelling) {
    return std::make_unique<ModellingPoints>(receivers, points);
  }
  return std::make_unique<GlarePoints>(receivers, field.glare, channel_weights, points);
}

}  // namespace rules
