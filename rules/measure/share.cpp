#include "rules/measure/share.h"

#include "rules/catalogue/compare.h"
#include "rules/measure/candidates.h"
#include "rules/measure/replicate_sample.h"

#include <algorithm>

namespace rules {
namespace {

bool is_in(const ValueRange& range, double value) {
  return meets(value, Comparison::at_least, range.from) &&
         meets(value, Comparison::at_most, range.to);
}

bool is_doubtful(const PointValues& values, std::size_t point) {
  return values.is_unseen(point) || values.is_untrusted(point);
}

// limits_of(point), is_doubt_of(point).
template <class LimitsOf, class IsDoubtOf>
ShareEstimate share_of_points(std::size_t count, const ValueRange& range, const LimitsOf& limits_of,
                              const IsDoubtOf& is_doubt_of) {
  const auto points = static_cast<double>(count);
  ShareEstimate share;
  share.open.assign(count, 0);
  std::size_t value = 0, certain = 0, possible = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Limits limits = limits_of(i);
    const bool is_doubt = is_doubt_of(i);
    const bool is_certain = !is_doubt && is_in(range, limits.low) && is_in(range, limits.high);
    // Something between the limits is in the range.
    const bool is_possible = is_doubt || (meets(limits.high, Comparison::at_least, range.from) &&
                                          meets(limits.low, Comparison::at_most, range.to));
    value += is_in(range, limits.value) ? 1 : 0;
    certain += is_certain ? 1 : 0;
    possible += is_possible ? 1 : 0;
    share.open[i] = is_possible && !is_certain ? 1 : 0;
  }
  const auto share_of = [points](std::size_t part) { return static_cast<double>(part) / points; };
  share.estimate = {share_of(value), share_of(std::min(certain, value)),
                    share_of(std::max(possible, value))};
  return share;
}

// Returns t for each of this many points.
double shared_t(std::size_t points, std::size_t replicates, double confidence) {
  return one_sided_t(replicates, 0.5 * (1.0 - confidence) / static_cast<double>(points));
}

}  // namespace

ShareEstimate compute_share(const PointValues& values, const ValueRange& range, double confidence) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const double t = shared_t(values.points, values.replicates, confidence);
  return share_of_points(
      values.points, range, [&](std::size_t i) { return point_limits(all, i, t); },
      [&](std::size_t i) { return is_doubtful(values, i); });
}

ShareEstimate compute_share(const DerivedPoints& points, const ValueRange& range,
                            double confidence) {
  const double t = shared_t(points.points(), points.replicates(), confidence);
  return share_of_points(
      points.points(), range, [&](std::size_t i) { return points.limits(i, t); },
      [&](std::size_t i) { return points.is_doubtful(i); });
}

}  // namespace rules
