#include "rules/measure/leave_one_out.h"

#include "calc/base/statistics.h"
#include "rules/measure/replicate_sample.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rules {
namespace {

double ranked_value(std::vector<double> means_lx, std::size_t rank) {
  const auto nth = means_lx.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(means_lx.begin(), nth, means_lx.end());
  return *nth;
}

// Returns the metric of the means over the other replicates; NaN: not defined.
double value_of(const std::vector<double>& means_lx, double average_lx, Metric metric,
                double percent, std::optional<std::size_t> point) {
  const auto [min, max] = std::minmax_element(means_lx.begin(), means_lx.end());
  switch (metric) {
    case Metric::average:
      return average_lx;
    case Metric::minimum:
      return *min;
    case Metric::maximum:
      return *max;
    case Metric::uniformity_min_avg:
      return *min / average_lx;
    case Metric::uniformity_min_max:
      return *min / *max;
    case Metric::percentile:
      return ranked_value(means_lx, percentile_rank(percent, means_lx.size()));
    case Metric::value_at_point:
      return means_lx[point.value()];
    default:  // not from values alone, see MetricSource and measure.cpp
      break;
  }
  return std::nan("");
}

}  // namespace

std::vector<double> without_each_replicate(const PointValues& values, Metric metric, double percent,
                                           std::optional<std::size_t> point) {
  if (values.replicates < 2) return {};
  const auto others = static_cast<double>(values.replicates - 1);
  const std::vector<double> of_plane_lx = plane_means(values);
  const double plane_sum_lx = std::accumulate(of_plane_lx.begin(), of_plane_lx.end(), 0.0);
  std::vector<double> sum_lx(values.points, 0.0), means_lx(values.points), result;
  for (std::size_t r = 0; r < values.replicates; ++r) {
    for (std::size_t i = 0; i < values.points; ++i) sum_lx[i] += values.at(r, i);
  }
  for (std::size_t r = 0; r < values.replicates; ++r) {
    for (std::size_t i = 0; i < values.points; ++i) {
      means_lx[i] = (sum_lx[i] - values.at(r, i)) / others;
    }
    const double average_lx = (plane_sum_lx - of_plane_lx[r]) / others;
    result.push_back(value_of(means_lx, average_lx, metric, percent, point));
    if (!std::isfinite(result.back())) return {};
  }
  return result;
}

std::vector<double> without_each_replicate(
    const PointValues& values,
    const std::function<std::optional<double>(const PointValues&)>& statistic) {
  std::vector<double> result;
  if (values.replicates < 2) return result;
  const auto points = static_cast<std::ptrdiff_t>(values.points);
  for (std::size_t r = 0; r < values.replicates; ++r) {
    PointValues others = values;
    for (std::vector<double>* lx : {&others.value_lx, &others.even_lx}) {
      if (lx->empty()) continue;
      const auto row = lx->begin() + static_cast<std::ptrdiff_t>(r) * points;
      lx->erase(row, row + points);
    }
    --others.replicates;
    const std::optional<double> value = statistic(others);
    if (!value || !std::isfinite(*value)) return {};
    result.push_back(*value);
  }
  return result;
}

calc::Estimate paired_difference(const std::vector<double>& before,
                                 const std::vector<double>& after, double value,
                                 double confidence) {
  const std::size_t count = before.size();
  std::vector<double> differences;
  for (std::size_t r = 0; r < count; ++r) differences.push_back(after[r] - before[r]);
  const double mean =
      std::accumulate(differences.begin(), differences.end(), 0.0) / static_cast<double>(count);
  double squares = 0.0;
  for (const double difference : differences) squares += (difference - mean) * (difference - mean);
  const double error =
      std::sqrt(squares * static_cast<double>(count - 1) / static_cast<double>(count));
  const double half_width =
      error * calc::student_t_quantile(0.5 * (1.0 + confidence), static_cast<int>(count) - 1);
  return {value, value - half_width, value + half_width};
}

}  // namespace rules
