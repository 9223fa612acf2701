#include "rules/share.h"

#include "rules/candidates.h"
#include "rules/compare.h"
#include "rules/replicate_sample.h"

#include <algorithm>

namespace rules {
namespace {

bool is_in(const ValueRange& range, double value) {
  return meets(value, Comparison::at_least, range.from) &&
         meets(value, Comparison::at_most, range.to);
}

bool is_doubtful(const PointValues& values, std::size_t point) {
  return (!values.unseen.empty() && values.unseen[point] != 0) ||
         (!values.largest_share.empty() && values.largest_share[point] > kLargestTrustedShare);
}

}  // namespace

ShareEstimate compute_share(const PointValues& values, const ValueRange& range, double confidence) {
  const ReplicateSample all = summarize(values, 0, values.replicates);
  const auto points = static_cast<double>(values.points);
  const double t = one_sided_t(values.replicates, 0.5 * (1.0 - confidence) / points);
  ShareEstimate share;
  share.open.assign(values.points, 0);
  std::size_t value = 0, certain = 0, possible = 0;
  for (std::size_t i = 0; i < values.points; ++i) {
    const Limits limits = point_limits(all, i, t);
    const bool is_doubt = is_doubtful(values, i);
    const bool is_certain = !is_doubt && is_in(range, limits.low) && is_in(range, limits.high);
    // Something between the limits is in the range.
    const bool is_possible = is_doubt || (meets(limits.high, Comparison::at_least, range.from) &&
                                          meets(limits.low, Comparison::at_most, range.to));
    value += is_in(range, limits.value) ? 1 : 0;
    certain += is_certain ? 1 : 0;
    possible += is_possible ? 1 : 0;
    share.open[i] = is_possible && !is_certain ? 1 : 0;
  }
  const auto share_of = [points](std::size_t count) { return static_cast<double>(count) / points; };
  share.estimate = {share_of(value), share_of(std::min(certain, value)),
                    share_of(std::max(possible, value))};
  return share;
}

}  // namespace rules
