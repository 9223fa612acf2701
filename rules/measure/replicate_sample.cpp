#include "rules/measure/replicate_sample.h"

#include "calc/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rules {

namespace {

// Differences, as below.
double weighted_mean(const PointValues& values, std::size_t replicate) {
  const double first = values.at(replicate, 0);
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < values.points; ++i) {
    sum += values.weight[i] * (values.at(replicate, i) - first);
    weights += values.weight[i];
  }
  return first + sum / weights;
}

}  // namespace

std::vector<double> plane_means(const PointValues& values) {
  std::vector<double> means;
  means.reserve(values.replicates);
  for (std::size_t r = 0; r < values.replicates; ++r) {
    if (!values.weight.empty()) {
      means.push_back(weighted_mean(values, r));
      continue;
    }
    const double first =
        values.at(r, 0);  // differences: a uniform plane has exactly its value as mean
    double sum = 0.0;
    for (std::size_t i = 0; i < values.points; ++i) sum += values.at(r, i) - first;
    means.push_back(first + sum / static_cast<double>(values.points));
  }
  return means;
}

ReplicateSample summarize(const PointValues& values, std::size_t first, std::size_t count) {
  const std::vector<double> all_means = plane_means(values);
  const std::span<const double> plane = std::span(all_means).subspan(first, count);
  const calc::ReplicateMean plane_mean = calc::replicate_mean(plane);

  ReplicateSample sample;
  sample.replicates = count;
  sample.plane_mean_lx = plane_mean.mean;
  sample.plane_variance = plane_mean.standard_error * plane_mean.standard_error;
  sample.mean_lx.resize(values.points);
  sample.variance.resize(values.points);
  sample.covariance.resize(values.points);
  std::vector<double> column(count);
  for (std::size_t i = 0; i < values.points; ++i) {
    for (std::size_t r = 0; r < count; ++r) column[r] = values.at(first + r, i);
    const calc::ReplicateMean mean = calc::replicate_mean(column);
    sample.mean_lx[i] = mean.mean;
    sample.variance[i] = mean.standard_error * mean.standard_error;
    if (count == 1) continue;
    double products = 0.0;
    for (std::size_t r = 0; r < count; ++r) {
      products += (column[r] - mean.mean) * (plane[r] - plane_mean.mean);
    }
    sample.covariance[i] = products / (static_cast<double>(count - 1) * static_cast<double>(count));
  }
  return sample;
}

double one_sided_t(std::size_t replicates, double level) {
  if (replicates == 1) return 0.0;
  // The lower tail: a small level would lose its digits in 1 - level.
  return -calc::student_t_quantile(level, static_cast<int>(replicates) - 1);
}

Limits point_limits(const ReplicateSample& sample, std::size_t point, double t) {
  const double mean = sample.mean_lx[point];
  const double half_width = t * std::sqrt(sample.variance[point]);
  return Limits{mean - half_width, mean, mean + half_width};
}

Limits ratio_limits(const ReplicateSample& sample, std::size_t point, double t) {
  return fieller_limits({sample.mean_lx[point], sample.plane_mean_lx, sample.variance[point],
                         sample.covariance[point], sample.plane_variance},
                        t);
}

Limits fieller_limits(const MeanPair& means, double t) {
  // The limits of a - u b vanish where
  //   (a - u b)^2 = t^2 (v11 - 2 u v12 + u^2 v22),   that is   A u^2 - 2 B u + C = 0.
  const double a = means.a;
  const double b = means.b;
  const double v11 = means.variance_a;
  const double v12 = means.covariance;
  const double v22 = means.variance_b;
  const double A = b * b - t * t * v22;
  const double B = a * b - t * t * v12;
  const double C = a * a - t * t * v11;
  // B^2 - A C without the digits that cancel; what is left is >= 0 wherever a root is asked for.
  const double discriminant = t * t * (a * a * v22 - 2.0 * a * b * v12 + b * b * v11) -
                              t * t * t * t * (v11 * v22 - v12 * v12);
  const double root = std::sqrt(std::max(discriminant, 0.0));

  Limits limits{0.0, b > 0.0 ? a / b : 0.0, std::numeric_limits<double>::infinity()};
  const double low_at_zero = a - t * std::sqrt(v11);  // lower limit of a itself
  // The lower limit of a - u b is a concave function of u: positive at 0, it has one root
  // beyond.
  limits.low = low_at_zero > 0.0 ? C / (B + root) : std::min(low_at_zero, 0.0);
  // The upper limit falls strictly, and so has one root, if the denominator is surely positive.
  if (b > t * std::sqrt(v22)) limits.high = (B + root) / A;
  return limits;
}

}  // namespace rules
