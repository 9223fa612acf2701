#include "rules/measure/replicate_sample.h"

#include "calc/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rules {

namespace {

// Returns the mean of a replicate from differences, as below.
double weighted_mean(const PointValues& values, std::size_t replicate) {
  const double first = values.even_at(replicate, 0);
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < values.points; ++i) {
    sum += values.weight[i] * (values.even_at(replicate, i) - first);
    weights += values.weight[i];
  }
  return first + sum / weights;
}

// Returns the largest sample of the plane's mean: a light vertex adds to all points around it, at
// most four of a grid with steps as long as the reach of its light, and never more than all.
double largest_of_plane(const PointValues& values, double scale) {
  if (values.largest_sample_lx.empty()) return 0.0;
  double sum = 0.0, squares = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < values.points; ++i) {
    const double weight = values.weight.empty() ? 1.0 : values.weight[i];
    const double part = weight * values.largest_sample_lx[i];
    sum += part;
    squares += part * part;
    weights += weight;
  }
  const double neighbours = 2.0 * std::sqrt(squares);  // four points whose noise is the same
  return scale * std::min(std::abs(sum), neighbours) / weights;
}

Limits widened(double mean, double variance, double largest, double t) {
  const double half_width = t * std::sqrt(variance);
  const double wider = t * std::sqrt(variance_with(variance, largest));
  return largest < 0.0 ? Limits{mean - wider, mean, mean + half_width}
                       : Limits{mean - half_width, mean, mean + wider};
}

// The limits of a - u b vanish where
//   (a - u b)^2 = t^2 (v11 - 2 u v12 + u^2 v22),   that is   A u^2 - 2 B u + C = 0.
class FiellerRoots {
 public:
  FiellerRoots(const MeanPair& means, double t)
      : a_(means.a),
        b_(means.b),
        error_a_(t * std::sqrt(means.variance_a)),
        error_b_(t * std::sqrt(means.variance_b)) {
    const double v11 = means.variance_a, v12 = means.covariance, v22 = means.variance_b;
    A_ = b_ * b_ - t * t * v22;
    B_ = a_ * b_ - t * t * v12;
    C_ = a_ * a_ - t * t * v11;
    // B^2 - A C without the digits that cancel; what is left is >= 0 wherever a root is asked for.
    const double discriminant = t * t * (a_ * a_ * v22 - 2.0 * a_ * b_ * v12 + b_ * b_ * v11) -
                                t * t * t * t * (v11 * v22 - v12 * v12);
    root_ = std::sqrt(std::max(discriminant, 0.0));
  }

  // The lower limit of a - u b is a concave function of u: positive at 0, it has one root beyond.
  double low() const {
    const double low_at_zero = a_ - error_a_;  // lower limit of a itself
    return low_at_zero > 0.0 ? C_ / (B_ + root_) : std::min(low_at_zero, 0.0);
  }
  // The upper limit falls strictly, and so has one root, if the denominator is surely positive.
  double high() const {
    return b_ > error_b_ ? (B_ + root_) / A_ : std::numeric_limits<double>::infinity();
  }

 private:
  double a_, b_, error_a_, error_b_;
  double A_ = 0.0, B_ = 0.0, C_ = 0.0, root_ = 0.0;
};

}  // namespace

std::vector<double> plane_means(const PointValues& values) {
  std::vector<double> means;
  means.reserve(values.replicates);
  for (std::size_t r = 0; r < values.replicates; ++r) {
    if (!values.weight.empty()) {
      means.push_back(weighted_mean(values, r));
      continue;
    }
    // Differences: a uniform plane has exactly its value as mean.
    const double first = values.even_at(r, 0);
    double sum = 0.0;
    for (std::size_t i = 0; i < values.points; ++i) sum += values.even_at(r, i) - first;
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
  // Of fewer replicates a sample is a larger part.
  const double scale = static_cast<double>(values.replicates) / static_cast<double>(count);
  sample.plane_largest_lx = largest_of_plane(values, scale);
  sample.largest_sample_lx.resize(values.points);
  std::vector<double> column(count);
  for (std::size_t i = 0; i < values.points; ++i) {
    sample.largest_sample_lx[i] = scale * values.largest_sample_at(i);
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

double variance_with(double variance, double sample) {
  constexpr double kStandardErrors = 2.0;
  const double more = kStandardErrors * sample;
  return variance + more * more;
}

Limits point_limits(const ReplicateSample& sample, std::size_t point, double t) {
  return widened(sample.mean_lx[point], sample.variance[point], sample.largest_sample_lx[point], t);
}

Limits plane_limits(const ReplicateSample& sample, double t) {
  return widened(sample.plane_mean_lx, sample.plane_variance, sample.plane_largest_lx, t);
}

Limits ratio_limits(const ReplicateSample& sample, std::size_t point, double t) {
  return fieller_limits({sample.mean_lx[point], sample.plane_mean_lx, sample.variance[point],
                         sample.covariance[point], sample.plane_variance,
                         sample.largest_sample_lx[point], sample.plane_largest_lx},
                        t);
}

// Returns the ratio: it is low where b is larger than measured, and high where a is.
Limits fieller_limits(const MeanPair& means, double t) {
  MeanPair low = means, high = means;
  low.variance_b = variance_with(means.variance_b, means.largest_b);
  high.variance_a = variance_with(means.variance_a, means.largest_a);
  return Limits{FiellerRoots(low, t).low(), means.b > 0.0 ? means.a / means.b : 0.0,
                FiellerRoots(high, t).high()};
}

}  // namespace rules
