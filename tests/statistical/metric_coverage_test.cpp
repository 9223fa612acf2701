// Do the intervals hold the truth as often as they claim? Synthetic replicates with known means,
// 4000 experiments. The generator (its output is specified) and the seed are fixed, so that a
// result does not change from run to run.

#include "rules/measure/metrics.h"
#include "tests/support/normal_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace rules::metric_coverage_test {
namespace {

constexpr std::size_t kFewPoints = 30;   // upper limits of the minimum share their level
constexpr std::size_t kManyPoints = 60;  // they come from the other half of the replicates
constexpr std::size_t kReplicates = 16;
constexpr int kExperiments = 4000;
constexpr double kConfidence = 0.95;
constexpr double kPercent = 20.0;  // rank 6 of 30, the last of the near-tie

// A plane with six points in a near-tie at the minimum, within a fraction of their noise.
std::vector<double> true_values_lx(std::size_t points) {
  std::vector<double> values(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = static_cast<double>(i);
    values[i] = i < 6 ? 300.0 + 0.2 * x : 320.0 + 8.0 * (x - 6.0);
  }
  return values;
}

// Noise of 1 % at each point of its own, and of 0.7 % that all points of a replicate share.
PointValues noisy_replicates(const std::vector<double>& truth_lx, NormalNumbers& normal) {
  PointValues values{truth_lx.size(), kReplicates, {}};
  values.value_lx.reserve(truth_lx.size() * kReplicates);
  for (std::size_t r = 0; r < kReplicates; ++r) {
    const double shared = 0.007 * normal.next();
    for (const double truth : truth_lx) {
      values.value_lx.push_back(truth * (1.0 + shared + 0.01 * normal.next()));
    }
  }
  return values;
}

struct Coverage {
  double share = 0.0;
  double mean_relative_width = 0.0;  // (high - low) / truth
};

Coverage coverage_of(Metric metric, std::size_t points = kFewPoints) {
  const std::vector<double> truth_lx = true_values_lx(points);
  const double truth =
      compute_metric(PointValues{points, 1, truth_lx}, metric, kPercent, 0, kConfidence)
          ->estimate.value;
  NormalNumbers normal(20211124);
  Coverage coverage;
  for (int experiment = 0; experiment < kExperiments; ++experiment) {
    const PointValues values = noisy_replicates(truth_lx, normal);
    const calc::Estimate estimate =
        compute_metric(values, metric, kPercent, 0, kConfidence)->estimate;
    if (estimate.low <= truth && truth <= estimate.high) coverage.share += 1.0 / kExperiments;
    coverage.mean_relative_width += (estimate.high - estimate.low) / truth / kExperiments;
  }
  ::testing::Test::RecordProperty("coverage", std::to_string(coverage.share));
  ::testing::Test::RecordProperty("mean_relative_width",
                                  std::to_string(coverage.mean_relative_width));
  return coverage;
}

// Exact for normal noise: 95 % within 3.3 standard deviations of a binomial share, sqrt(0.95 * 0.05
// / 4000) = 0.34 %.
constexpr double kBinomialBand = 0.0114;

// Measured coverage and mean width, (high - low) / truth, stand beside each claim.

TEST(MetricCoverage, OfTheAverageIsTheConfidence) {  // 94.9 %, 0.8 %
  const Coverage coverage = coverage_of(Metric::average);
  EXPECT_NEAR(coverage.share, kConfidence, kBinomialBand);
  EXPECT_LT(coverage.mean_relative_width, 0.009);
}

TEST(MetricCoverage, OfAPointIsTheConfidence) {  // 95.1 %, 1.3 %
  const Coverage coverage = coverage_of(Metric::value_at_point);
  EXPECT_NEAR(coverage.share, kConfidence, kBinomialBand);
  EXPECT_LT(coverage.mean_relative_width, 0.014);
}

TEST(MetricCoverage, OfTheMinimumIsAtLeastTheConfidence) {  // 99.8 %, 1.7 %
  const Coverage coverage = coverage_of(Metric::minimum);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.019);
}

TEST(MetricCoverage, OfTheMinimumOfManyPointsIsAtLeastTheConfidence) {
  const Coverage coverage = coverage_of(Metric::minimum, kManyPoints);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.021);
}

TEST(MetricCoverage, OfTheMaximumIsAtLeastTheConfidence) {  // 97.0 %, 1.8 %
  const Coverage coverage = coverage_of(Metric::maximum);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.019);
}

TEST(MetricCoverage, OfUoIsAtLeastTheConfidence) {  // 99.9 %, 1.4 %
  const Coverage coverage = coverage_of(Metric::uniformity_min_avg);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.016);
}

TEST(MetricCoverage, OfUoOfManyPointsIsAtLeastTheConfidence) {
  const Coverage coverage = coverage_of(Metric::uniformity_min_avg, kManyPoints);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.018);
}

TEST(MetricCoverage,
     OfUdIsAtLeastTheConfidence) {  // 100 %, 4.0 %: two conservative intervals combined
  const Coverage coverage = coverage_of(Metric::uniformity_min_max);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.043);
}

TEST(MetricCoverage, OfAPercentileIsAtLeastTheConfidence) {  // 99.2 %, 2.1 %
  const Coverage coverage = coverage_of(Metric::percentile);
  EXPECT_GE(coverage.share, 0.94);
  EXPECT_LT(coverage.mean_relative_width, 0.023);
}

// Few large samples beside normal noise: `expected` of them in all replicates, 1 lx each.
double coverage_with_large_samples(double expected, double noise_lx, Metric metric) {
  constexpr double kTruth = 100.0;
  constexpr auto kCount = static_cast<double>(kReplicates);
  std::mt19937_64 generator(7);
  std::poisson_distribution<int> samples(expected / kCount);
  NormalNumbers normal(8);
  int covered = 0;
  for (int experiment = 0; experiment < kExperiments; ++experiment) {
    PointValues values{1, kReplicates, {}};
    values.largest_sample_lx = {1.0};
    for (std::size_t r = 0; r < kReplicates; ++r) {
      values.value_lx.push_back(kTruth - expected + noise_lx * std::sqrt(kCount) * normal.next() +
                                kCount * samples(generator));
    }
    const calc::Estimate estimate =
        compute_metric(values, metric, kPercent, 0, kConfidence)->estimate;
    if (estimate.low <= kTruth && kTruth <= estimate.high) ++covered;
  }
  return static_cast<double>(covered) / kExperiments;
}

TEST(MetricCoverage, OfFewLargeSamplesIsTheConfidence) {
  for (const Metric metric : {Metric::value_at_point, Metric::average, Metric::minimum}) {
    for (const double expected : {0.1, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0}) {
      for (const double noise_lx : {0.01, 0.5, 1.0}) {
        EXPECT_GE(coverage_with_large_samples(expected, noise_lx, metric),
                  kConfidence - kBinomialBand)
            << expected << " samples, noise " << noise_lx;
      }
    }
  }
}

}  // namespace
}  // namespace rules::metric_coverage_test
