#include "rules/measure/replicate_sample.h"

#include "calc/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rules {
namespace {

// Rows are replicates.
PointValues three_points() {
  return PointValues{3,
                     4,
                     {10, 20, 30,  //
                      12, 20, 34,  //
                      11, 26, 32,  //
                      15, 22, 32}};
}

TEST(Summarize, IsMeansVariancesAndCovariancesByHand) {
  const ReplicateSample sample = summarize(three_points(), 0, 4);
  // point 0: mean 12, deviations -2 0 -1 3; plane means 20 22 23 23, mean 22, deviations -2 0 1 1
  EXPECT_DOUBLE_EQ(sample.mean_lx[0], 12.0);
  EXPECT_DOUBLE_EQ(sample.variance[0], 14.0 / 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(sample.plane_mean_lx, 22.0);
  EXPECT_DOUBLE_EQ(sample.plane_variance, 6.0 / 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(sample.covariance[0], (4.0 - 1.0 + 3.0) / 3.0 / 4.0);
}

TEST(Summarize, TakesOnlyTheReplicatesAskedFor) {
  const ReplicateSample sample = summarize(three_points(), 2, 2);
  EXPECT_EQ(sample.replicates, 2u);
  EXPECT_DOUBLE_EQ(sample.mean_lx[1], 24.0);
  EXPECT_DOUBLE_EQ(sample.plane_mean_lx, 23.0);
  EXPECT_DOUBLE_EQ(sample.variance[1], 8.0 / 1.0 / 2.0);
}

TEST(Summarize, OfOneReplicateHasNoVariance) {
  const ReplicateSample sample = summarize(three_points(), 1, 1);
  EXPECT_EQ(sample.mean_lx[2], 34.0);
  EXPECT_EQ(sample.variance[2], 0.0);
  EXPECT_EQ(sample.covariance[2], 0.0);
  EXPECT_EQ(one_sided_t(sample.replicates, 0.025), 0.0);
}

TEST(PointLimits, AreTStandardErrorsFromTheMean) {
  const ReplicateSample sample = summarize(three_points(), 0, 4);
  const Limits limits = point_limits(sample, 0, one_sided_t(sample.replicates, 0.025));
  const double half_width = 3.182446305284263 * std::sqrt(14.0 / 12.0);
  EXPECT_NEAR(limits.low, 12.0 - half_width, 1e-12);
  EXPECT_EQ(limits.value, 12.0);
  EXPECT_NEAR(limits.high, 12.0 + half_width, 1e-12);
}

// E_i - u * mean(E) in every replicate, and its one-sided limits from first principles.
calc::Estimate difference_limits(const PointValues& values, std::size_t point, double u,
                                 double level) {
  const std::vector<double> means = plane_means(values);
  std::vector<double> difference;
  for (std::size_t r = 0; r < values.replicates; ++r) {
    difference.push_back(values.at(r, point) - u * means[r]);
  }
  return calc::t_interval(difference, 1.0 - 2.0 * level);
}

TEST(RatioLimits, AreWhereTheLimitsOfTheDifferenceVanish) {
  const PointValues values = three_points();
  const ReplicateSample sample = summarize(values, 0, 4);
  for (const double level : {0.2, 0.025, 0.005}) {
    const double t = one_sided_t(sample.replicates, level);
    for (std::size_t i = 0; i < 3; ++i) {
      const Limits limits = ratio_limits(sample, i, t);
      EXPECT_DOUBLE_EQ(limits.value, sample.mean_lx[i] / 22.0);
      EXPECT_LT(limits.low, limits.value);
      EXPECT_GT(limits.high, limits.value);
      EXPECT_NEAR(difference_limits(values, i, limits.low, level).low, 0.0, 1e-11);
      EXPECT_NEAR(difference_limits(values, i, limits.high, level).high, 0.0, 1e-11);
    }
  }
}

TEST(RatioLimits, OfAConstantRatioCoincide) {
  // Point 1 is always the plane's mean, whatever the mean is.
  const PointValues values{3, 3, {10, 20, 30, 15, 30, 45, 7, 14, 21}};
  const Limits limits = ratio_limits(summarize(values, 0, 3), 1, 4.0);
  EXPECT_NEAR(limits.low, 1.0, 1e-12);
  EXPECT_NEAR(limits.high, 1.0, 1e-12);
}

TEST(RatioLimits, HaveNoUpperEndIfTheDenominatorMayBeZero) {
  const PointValues values{2, 3, {1, 3, 0, 0, 5, 7}};  // plane means 2, 0, 6
  const ReplicateSample sample = summarize(values, 0, 3);
  const Limits limits = ratio_limits(sample, 0, 10.0);
  EXPECT_EQ(limits.high, std::numeric_limits<double>::infinity());
  EXPECT_LE(limits.low, 0.0);
}

TEST(RatioLimits, OfADarkPointAreZero) {
  const PointValues values{2, 3, {0, 10, 0, 12, 0, 11}};
  const Limits limits = ratio_limits(summarize(values, 0, 3), 0, 4.3);
  EXPECT_EQ(limits.low, 0.0);
  EXPECT_EQ(limits.value, 0.0);
  EXPECT_EQ(limits.high, 0.0);
}

// The denominator is not surely positive, but the numerator is: the lower limit is still the root.
TEST(RatioLimits, HaveALowerEndWithAnUncertainDenominator) {
  const PointValues values{2, 3, {10, 2, 10.1, 90, 9.9, 150}};
  const ReplicateSample sample = summarize(values, 0, 3);
  const double t = one_sided_t(sample.replicates, 0.025);
  ASSERT_LT(sample.plane_mean_lx, t * std::sqrt(sample.plane_variance));
  const Limits limits = ratio_limits(sample, 0, t);
  EXPECT_GT(limits.low, 0.0);
  EXPECT_NEAR(difference_limits(values, 0, limits.low, 0.025).low, 0.0, 1e-9);
}

}  // namespace
}  // namespace rules
