#include "rules/measure/neighbour_pairs.h"

#include "calc/base/statistics.h"
#include "rules/measure/candidates.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace rules {
namespace {

double square(double x) { return x * x; }

// Returns the means of two points, with the variances and the covariance of the means.
MeanPair means_of(const PointValues& values, std::size_t a, std::size_t b) {
  std::vector<double> of_a, of_b;
  for (std::size_t r = 0; r < values.replicates; ++r) {
    of_a.push_back(values.at(r, a));
    of_b.push_back(values.at(r, b));
  }
  const calc::ReplicateMean mean_a = calc::replicate_mean(of_a);
  const calc::ReplicateMean mean_b = calc::replicate_mean(of_b);
  const auto count = static_cast<double>(values.replicates);
  double products = 0.0;
  for (std::size_t r = 0; r < values.replicates; ++r) {
    products += (of_a[r] - mean_a.mean) * (of_b[r] - mean_b.mean);
  }
  const double covariance = values.replicates < 2 ? 0.0 : products / ((count - 1.0) * count);
  return {mean_a.mean,
          mean_b.mean,
          square(mean_a.standard_error),
          covariance,
          square(mean_b.standard_error),
          values.largest_sample_at(a),
          values.largest_sample_at(b)};
}

}  // namespace

NeighbourPairs::NeighbourPairs(const PointValues& values, const calc::SensorGrid& grid,
                               const std::vector<std::size_t>& chosen) {
  replicates_ = values.replicates;
  if (grid.columns == 0) return;  // a list of points has no neighbours
  std::map<std::pair<int, int>, std::size_t> place_of_cell;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    place_of_cell[{grid.column[chosen[i]], grid.row[chosen[i]]}] = i;
  }
  for (const auto& [cell, place] : place_of_cell) {
    for (const auto& [columns, rows] : {std::pair{1, 0}, std::pair{0, 1}}) {
      const auto other = place_of_cell.find({cell.first + columns, cell.second + rows});
      if (other == place_of_cell.end()) continue;
      add(values, place, other->second);
      add(values, other->second, place);
    }
  }
}

void NeighbourPairs::add(const PointValues& values, std::size_t a, std::size_t b) {
  pairs_.push_back({a, b});
  means_.push_back(means_of(values, a, b));
  unseen_.push_back(values.is_unseen(a) || values.is_unseen(b) ? 1 : 0);
  single_sample_.push_back(values.is_untrusted(a) || values.is_untrusted(b) ? 1 : 0);
}

Limits NeighbourPairs::limits(std::size_t pair, double t) const {
  const MeanPair& means = means_[pair];
  // Two dark points are alike.
  if (!(means.a > 0.0) && !(means.b > 0.0)) return {1.0, 1.0, 1.0};
  Limits limits = fieller_limits(means, t);
  if (!(means.b > 0.0)) limits.value = kInfinity;
  limits.low = std::clamp(limits.low, 0.0, limits.value);
  limits.high = std::max(limits.high, limits.value);
  return limits;
}

}  // namespace rules
