#pragma once
// Means over a run of replicates and their uncertainty: the basis of every interval of a plane.

#include "rules/measure/metrics.h"

#include <cstddef>
#include <vector>

namespace rules {

// Means of the replicates first, ..., first + replicates - 1. Variances and covariances are those
// of the means (s^2 / R), in lx^2, and 0 for one replicate, which counts as exact.
struct ReplicateSample {
  std::size_t replicates = 0;
  std::vector<double> mean_lx;     // per point
  std::vector<double> variance;    // per point
  std::vector<double> covariance;  // per point, of its mean with the plane's mean
  double plane_mean_lx = 0.0;      // mean over the points, by their weights
  double plane_variance = 0.0;
  std::vector<double> largest_sample_lx;  // per point, what it adds to the mean
  double plane_largest_lx = 0.0;  // of neighbours together, what they add to the plane's mean
};

// Returns the means of these replicates. Requires first + count <= values.replicates, count >= 1
// and values.points >= 1.
ReplicateSample summarize(const PointValues& values, std::size_t first, std::size_t count);

// Returns the mean over the points for each replicate.
std::vector<double> plane_means(const PointValues& values);

// Returns t such that mean + t * standard error falls below the true value with probability `level`
// only, for means over this many replicates; 0 for one replicate, which counts as exact.
double one_sided_t(std::size_t replicates, double level);

// Lower, plug-in and upper value of one quantity at one point.
struct Limits {
  double low, value, high;
};

using LimitsOfPoint = Limits (*)(const ReplicateSample& sample, std::size_t point, double t);

// Returns the variance of the mean for an upper limit, where one sample adds `sample` to the mean.
// Light is a sum of many small samples and a few large ones. The number of large samples is a
// Poisson number, and none may have been drawn: then up to -ln(level) of them are still expected,
// 1.7 to 2 times t for all levels in use, which neither the mean nor the variance shows. Samples
// are never negative, so a lower limit needs no such term.  [METHOD, 7.1]
double variance_with(double variance, double sample);

// Returns mean -+ t * standard error, with the largest sample added upwards (downwards if
// mirrored).
Limits point_limits(const ReplicateSample& sample, std::size_t point, double t);
// Returns the same limits for the plane's mean.
Limits plane_limits(const ReplicateSample& sample, double t);

// Two means a, b, with the variances and the covariance of the means, and the largest samples.
struct MeanPair {
  double a, b, variance_a, covariance, variance_b;
  double largest_a = 0.0, largest_b = 0.0;
};

// Returns the ratio a / b by Fieller's theorem, restricted to ratios >= 0:
//   low:  the largest u for which a - u b has a lower limit >= 0, also for every smaller u;
//   negative if there is none
//   high: the largest u that the upper limit does not refute; infinite if b itself may be 0
// so that low >= u exactly when the lower limit of a - u b is >= 0.  [Fieller54; METHOD, 7.3]
// Requires b > 0, except that `high` is also right (infinite) for b = 0.
Limits fieller_limits(const MeanPair& means, double t);

// Returns the limits of the ratio of the point's mean to the plane's mean.
Limits ratio_limits(const ReplicateSample& sample, std::size_t point, double t);

}  // namespace rules
