#include "rules/measure/replicate_sample.h"

#include "calc/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace rules::replicate_sample_test {
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

PointValues with_samples(std::vector<double> largest_lx) {
  PointValues values = three_points();
  values.largest_sample_lx = std::move(largest_lx);
  return values;
}

// If no sample as large as this was drawn, -ln(0.025) = 3.7 of them may still be expected: with
// nothing else known they reach as far up as that.
TEST(PointLimits, ReachUpForASampleThatWasNotDrawn) {
  const PointValues values = with_samples({1.0, 0.0, 0.0});
  const ReplicateSample sample = summarize(values, 0, 4);
  const ReplicateSample plain = summarize(three_points(), 0, 4);
  constexpr double kT = 2.13;  // of 16 replicates
  const Limits limits = point_limits(sample, 0, kT);
  EXPECT_EQ(limits.low, point_limits(plain, 0, kT).low);
  EXPECT_NEAR(limits.high, 12.0 + kT * std::sqrt(14.0 / 12.0 + 4.0), 1e-12);
  EXPECT_EQ(point_limits(sample, 1, kT).high, point_limits(plain, 1, kT).high);
  ReplicateSample quiet = sample;
  quiet.variance[0] = 0.0;
  EXPECT_GT(point_limits(quiet, 0, kT).high, 12.0 + 3.7);
}

TEST(PointLimits, OfMirroredValuesReachDown) {
  PointValues values = with_samples({-1.0, 0.0, 0.0});
  const Limits limits = point_limits(summarize(values, 0, 4), 0, 2.0);
  EXPECT_NEAR(limits.low, 12.0 - 2.0 * std::sqrt(14.0 / 12.0 + 4.0), 1e-12);
  EXPECT_NEAR(limits.high, 12.0 + 2.0 * std::sqrt(14.0 / 12.0), 1e-12);
}

TEST(Summarize, ASampleIsALargerPartOfFewerReplicates) {
  EXPECT_EQ(summarize(with_samples({1.5, 0.0, 0.0}), 0, 2).largest_sample_lx[0], 3.0);
}

// One vertex adds to neighbouring points, at most to all of them.
TEST(PlaneLimits, ReachUpForWhatNeighboursShare) {
  EXPECT_DOUBLE_EQ(summarize(with_samples({3.0, 0.0, 0.0}), 0, 4).plane_largest_lx, 1.0);
  EXPECT_DOUBLE_EQ(summarize(with_samples({3.0, 3.0, 3.0}), 0, 4).plane_largest_lx, 3.0);
  PointValues many{100, 2, std::vector<double>(200, 5.0)};
  many.largest_sample_lx.assign(100, 3.0);
  EXPECT_DOUBLE_EQ(summarize(many, 0, 2).plane_largest_lx, 0.6);  // 2 sqrt(100) 3 / 100
  many.weight.assign(100, 1.0);
  many.weight[0] = 901.0;  // of 1000
  EXPECT_NEAR(summarize(many, 0, 2).plane_largest_lx, 3.0, 1e-12);
  const ReplicateSample sample = summarize(with_samples({3.0, 0.0, 0.0}), 0, 4);
  EXPECT_NEAR(plane_limits(sample, 2.0).high, 22.0 + 2.0 * std::sqrt(0.5 + 4.0), 1e-12);
  EXPECT_NEAR(plane_limits(sample, 2.0).low, 22.0 - 2.0 * std::sqrt(0.5), 1e-12);
}

// More in the numerator than was measured lifts the upper end, more in the denominator lowers the
// lower one.
TEST(RatioLimits, ReachFartherForSamplesThatWereNotDrawn) {
  const MeanPair plain{10.0, 20.0, 0.01, 0.0, 0.04};
  MeanPair a = plain, b = plain;
  a.largest_a = 0.5;
  b.largest_b = 0.5;
  const Limits of_plain = fieller_limits(plain, 2.0), of_a = fieller_limits(a, 2.0),
               of_b = fieller_limits(b, 2.0);
  EXPECT_EQ(of_a.low, of_plain.low);
  EXPECT_GT(of_a.high, of_plain.high + 0.05);
  EXPECT_LT(of_b.low, of_plain.low - 0.02);
  EXPECT_EQ(of_b.high, of_plain.high);
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
}  // namespace rules::replicate_sample_test
