#include "rules/measure/metrics.h"

#include "calc/base/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rules::metrics_test {
namespace {

// One-sided t factors of 3 and 7 degrees of freedom (from tables with more digits).
constexpr double kT3_025 = 3.182446305284263;
constexpr double kT3_0125 = 4.176534846;  // Bonferroni table: 4.177
constexpr double kT7_0125 = 2.841244248;  // 2.841

// Rows are replicates.
PointValues three_points() {
  return PointValues{3,
                     4,
                     {10, 20, 30,  //
                      12, 20, 34,  //
                      11, 26, 32,  //
                      15, 22, 32}};
}

PointValues exact(std::vector<double> values) {
  const std::size_t points = values.size();
  return PointValues{points, 1, std::move(values)};
}

// points x 16 replicates with the given means of the first and second half of the replicates, each
// +-1 in turn.
PointValues halves(const std::vector<double>& first, const std::vector<double>& second) {
  PointValues values{first.size(), 16, {}};
  for (std::size_t r = 0; r < 16; ++r) {
    for (std::size_t i = 0; i < first.size(); ++i) {
      values.value_lx.push_back((r < 8 ? first[i] : second[i]) + (r % 2 == 0 ? -1.0 : 1.0));
    }
  }
  return values;
}

std::vector<double> bright_plane(std::size_t points) {
  std::vector<double> means(points, 200.0);
  return means;
}

calc::Estimate metric_of(const PointValues& values, Metric metric, double percent = 0.0) {
  return compute_metric(values, metric, percent, std::nullopt, 0.95).value().estimate;
}

void expect_estimate(const calc::Estimate& estimate, double low, double value, double high) {
  EXPECT_NEAR(estimate.low, low, 1e-8);
  EXPECT_NEAR(estimate.value, value, 1e-8);
  EXPECT_NEAR(estimate.high, high, 1e-8);
}

TEST(Metric, OfAnExactFieldIsTheClosedFormWithoutAnInterval) {
  const PointValues values = exact({200, 600, 400});
  expect_estimate(metric_of(values, Metric::average), 400, 400, 400);
  expect_estimate(metric_of(values, Metric::minimum), 200, 200, 200);
  expect_estimate(metric_of(values, Metric::maximum), 600, 600, 600);
  expect_estimate(metric_of(values, Metric::uniformity_min_avg), 0.5, 0.5, 0.5);
  expect_estimate(metric_of(values, Metric::uniformity_min_max), 1.0 / 3, 1.0 / 3, 1.0 / 3);
  expect_estimate(metric_of(values, Metric::percentile, 50), 400, 400, 400);
  const auto at = compute_metric(values, Metric::value_at_point, 0, 1, 0.95);
  expect_estimate(at->estimate, 600, 600, 600);
}

TEST(Metric, OfAnExactFieldHasEqualBits) {
  const PointValues values = exact({100.1, 100.1, 300.7});
  for (const Metric metric :
       {Metric::average, Metric::minimum, Metric::maximum, Metric::uniformity_min_avg,
        Metric::uniformity_min_max, Metric::percentile}) {
    const calc::Estimate estimate = metric_of(values, metric, 40);
    EXPECT_EQ(estimate.low, estimate.value) << calc::name_of(metric);
    EXPECT_EQ(estimate.high, estimate.value) << calc::name_of(metric);
  }
}

TEST(Metric, NamesThePointThatAttainsIt) {
  const PointValues values = exact({300, 200, 600});
  const auto point_of = [&](Metric metric) {
    return compute_metric(values, metric, 50, 0, 0.95)->point;
  };
  EXPECT_EQ(point_of(Metric::minimum), 1u);
  EXPECT_EQ(point_of(Metric::maximum), 2u);
  EXPECT_EQ(point_of(Metric::uniformity_min_avg), 1u);
  EXPECT_EQ(point_of(Metric::uniformity_min_max), 1u);
  EXPECT_EQ(point_of(Metric::value_at_point), 0u);
  EXPECT_FALSE(point_of(Metric::average).has_value());
  EXPECT_FALSE(point_of(Metric::percentile).has_value());
}

TEST(Average, IsTheTIntervalOfThePlanesMeans) {
  const double half_width = kT3_025 * std::sqrt(6.0 / 12.0);  // means 20 22 23 23
  expect_estimate(metric_of(three_points(), Metric::average), 22 - half_width, 22, 22 + half_width);
}

// Of a route: cells at bends differ, and the average is that of the area.
TEST(Average, CountsPointsByTheirWeights) {
  PointValues values = exact({10, 20, 60});
  values.weight = {2, 1, 1};
  const auto of = [&](Metric metric) {
    return compute_metric(values, metric, 0.0, std::nullopt, 0.95)->estimate.value;
  };
  EXPECT_DOUBLE_EQ(of(Metric::average), 25.0);
  EXPECT_DOUBLE_EQ(of(Metric::uniformity_min_avg), 0.4);
  EXPECT_DOUBLE_EQ(of(Metric::minimum), 10.0);
  values = select_points(values, {0, 2});
  EXPECT_NEAR(of(Metric::average), (2 * 10 + 60) / 3.0, 1e-12);
}

TEST(ValueAtPoint, IsTheTIntervalOfThePoint) {
  const double half_width = kT3_025 * std::sqrt(24.0 / 12.0);  // 20 20 26 22
  const auto result = compute_metric(three_points(), Metric::value_at_point, 0, 1, 0.95);
  expect_estimate(result->estimate, 22 - half_width, 22, 22 + half_width);
}

TEST(Minimum, OfFewPointsSharesTheLevelOfTheUpperLimit) {
  // Two points, means 12 and 22: lower limits at 2.5 % each, upper limits at 2.5 % / 2 each.
  PointValues values{2, 4, {10, 20, 12, 20, 11, 26, 15, 22}};
  const double error = std::sqrt(14.0 / 12.0);
  expect_estimate(metric_of(values, Metric::minimum), 12 - kT3_025 * error, 12,
                  12 + kT3_0125 * error);
}

TEST(Minimum, TakesTheLowestLimitEvenOfABrighterPoint) {
  // Point 1 is brighter, but so noisy that it may be the darkest.
  PointValues values{2, 4, {100, 60, 101, 160, 99, 130, 100, 70}};
  const calc::Estimate noisy = compute_metric(values, Metric::value_at_point, 0, 1, 0.95)->estimate;
  const calc::Estimate minimum = metric_of(values, Metric::minimum);
  EXPECT_DOUBLE_EQ(minimum.value, 100.0);
  EXPECT_NEAR(minimum.low, noisy.low, 1e-9);
}

TEST(Minimum, OfManyPointsIsLimitedByTheOtherHalfOfTheReplicates) {
  std::vector<double> means = bright_plane(200);
  means[17] = 100.0;
  const double error_of_half = std::sqrt(8.0 / 7.0 / 8.0);
  const calc::Estimate minimum = metric_of(halves(means, means), Metric::minimum);
  EXPECT_EQ(minimum.value, 100.0);
  EXPECT_NEAR(minimum.high, 100.0 + kT7_0125 * error_of_half, 1e-8);
}

// Each half sees another point as the darkest. Limiting a point by the half that chose it would
// give 91.
TEST(Minimum, IsNotLimitedByTheReplicatesThatChoseThePoint) {
  std::vector<double> first = bright_plane(200);
  std::vector<double> second = first;
  first[3] = second[4] = 90.0;
  first[4] = second[3] = 100.0;
  const calc::Estimate minimum = metric_of(halves(first, second), Metric::minimum);
  EXPECT_EQ(minimum.value, 95.0);
  EXPECT_NEAR(minimum.high, 100.0 + kT7_0125 * std::sqrt(1.0 / 7.0), 1e-8);
}

// The second half limits point 3 to about 91, below the mean of all replicates.
TEST(Minimum, ContainsItsValue) {
  std::vector<double> first = bright_plane(200);
  std::vector<double> second = first;
  first[3] = 100.0;
  second[3] = 90.0;
  const calc::Estimate minimum = metric_of(halves(first, second), Metric::minimum);
  EXPECT_EQ(minimum.value, 95.0);
  EXPECT_EQ(minimum.high, 95.0);
}

TEST(Minimum, OfOnePointIsItsTInterval) {
  const PointValues values{1, 4, {10, 12, 11, 15}};
  const calc::Estimate average = metric_of(values, Metric::average);
  const calc::Estimate minimum = metric_of(values, Metric::minimum);
  EXPECT_NEAR(minimum.low, average.low, 1e-9);
  EXPECT_NEAR(minimum.high, average.high, 1e-9);
}

TEST(Minimum, NeedsNoMoreThanTwoReplicates) {
  const PointValues values{2, 2, {10, 20, 12, 24}};
  const double t = std::tan(M_PI * (0.5 - 0.0125));  // 1 degree of freedom
  EXPECT_NEAR(metric_of(values, Metric::minimum).high, 11 + t * 1.0, 1e-8);
}

TEST(Maximum, MirrorsTheMinimum) {
  const PointValues values = three_points();
  PointValues mirrored = values;
  for (double& value : mirrored.value_lx) value = 1000.0 - value;
  const calc::Estimate maximum = metric_of(values, Metric::maximum);
  const calc::Estimate minimum = metric_of(mirrored, Metric::minimum);
  EXPECT_EQ(maximum.value, 32.0);
  expect_estimate(maximum, 1000 - minimum.high, 1000 - minimum.value, 1000 - minimum.low);
}

// The lower end is the intersection-union test: Uo >= u passes if and only if every point's
// one-sided lower limit of E_i - u * mean(E) is >= 0.
TEST(Uo, HasTheIntersectionUnionTestAsLowerEnd) {
  PointValues values{5, 6, {}};
  for (std::size_t k = 0; k < 30; ++k) {  // scattered, but the same everywhere
    values.value_lx.push_back(100.0 + static_cast<double>((k * 37) % 23));
  }
  const double low = metric_of(values, Metric::uniformity_min_avg).low;
  for (const double u : {0.5, low - 1e-9, low + 1e-9, 0.9, 0.99}) {
    bool all_pass = true;
    for (std::size_t i = 0; i < values.points; ++i) {
      std::vector<double> difference;
      for (std::size_t r = 0; r < values.replicates; ++r) {
        const auto row = values.value_lx.begin() + static_cast<std::ptrdiff_t>(r * values.points);
        const double mean = std::accumulate(row, row + 5, 0.0) / 5.0;
        difference.push_back(values.at(r, i) - u * mean);
      }
      all_pass = all_pass && calc::t_interval(difference, 0.95).low >= 0.0;
    }
    EXPECT_EQ(all_pass, low >= u) << u;
  }
}

TEST(Uo, IsTheRatioOfTheMeans) {
  EXPECT_DOUBLE_EQ(metric_of(three_points(), Metric::uniformity_min_avg).value, 12.0 / 22.0);
}

TEST(Uo, IsNotBlurredByNoiseThatAllPointsShare) {
  // Every replicate is the same picture, darker or brighter.
  const PointValues values{3, 4, {10, 20, 30, 12, 24, 36, 8, 16, 24, 11, 22, 33}};
  expect_estimate(metric_of(values, Metric::uniformity_min_avg), 0.5, 0.5, 0.5);
}

TEST(Uo, StaysWithinZeroAndOne) {
  const PointValues values{2, 4, {0, 3, 5, 0, 0, 4, 2, 1}};
  const calc::Estimate uo = metric_of(values, Metric::uniformity_min_avg);
  EXPECT_EQ(uo.low, 0.0);
  EXPECT_LE(uo.value, 1.0);
  EXPECT_EQ(uo.high, 1.0);
}

TEST(Uo, OfAUniformPlaneIsOne) {
  expect_estimate(metric_of(exact({0.1, 0.1, 0.1}), Metric::uniformity_min_avg), 1, 1, 1);
}

TEST(Uniformity, OfADarkPlaneIsUndefined) {
  const PointValues dark = exact({0, 0, 0});
  EXPECT_FALSE(compute_metric(dark, Metric::uniformity_min_avg, 0, {}, 0.95).has_value());
  EXPECT_FALSE(compute_metric(dark, Metric::uniformity_min_max, 0, {}, 0.95).has_value());
  const PointValues sampled{2, 4, std::vector<double>(8, 0.0)};
  EXPECT_FALSE(compute_metric(sampled, Metric::uniformity_min_avg, 0, {}, 0.95).has_value());
  EXPECT_FALSE(compute_metric(sampled, Metric::uniformity_min_max, 0, {}, 0.95).has_value());
}

TEST(Uniformity, OfAPlaneWithADarkPointIsZero) {
  expect_estimate(metric_of(exact({0, 5}), Metric::uniformity_min_avg), 0, 0, 0);
  expect_estimate(metric_of(exact({0, 5}), Metric::uniformity_min_max), 0, 0, 0);
}

TEST(Ud, CombinesMinimumAndMaximumAtHalfTheRiskEach) {
  const PointValues values{2, 4, {100, 200, 102, 206, 98, 190, 100, 204}};
  const auto at_half_risk = [&](Metric metric) {
    return compute_metric(values, metric, 0, std::nullopt, 0.975)->estimate;
  };
  const calc::Estimate minimum = at_half_risk(Metric::minimum);
  const calc::Estimate maximum = at_half_risk(Metric::maximum);
  expect_estimate(metric_of(values, Metric::uniformity_min_max), minimum.low / maximum.high, 0.5,
                  minimum.high / maximum.low);
}

TEST(Percentile, IsTheSmallestValueThatEnoughPointsDoNotExceed) {
  const PointValues values = exact({50, 20, 90, 10, 40, 100, 70, 30, 80, 60});
  EXPECT_EQ(metric_of(values, Metric::percentile, 0).value, 10);
  EXPECT_EQ(metric_of(values, Metric::percentile, 10).value, 10);
  EXPECT_EQ(metric_of(values, Metric::percentile, 10.1).value, 20);
  EXPECT_EQ(metric_of(values, Metric::percentile, 50).value, 50);
  EXPECT_EQ(metric_of(values, Metric::percentile, 90).value, 90);
  EXPECT_EQ(metric_of(values, Metric::percentile, 90.1).value, 100);
  EXPECT_EQ(metric_of(values, Metric::percentile, 100).value, 100);
}

TEST(Percentile, IsNotMovedByBinaryNoiseOfTheShare) {
  for (std::size_t points = 1; points <= 1000; ++points) {
    std::vector<double> ranks(points);
    std::iota(ranks.begin(), ranks.end(), 1.0);
    const double rank = std::ceil(static_cast<double>(points) / 3.0);
    const double percent = 100.0 * rank / static_cast<double>(points);
    EXPECT_EQ(metric_of(exact(ranks), Metric::percentile, percent).value, rank) << points;
  }
}

TEST(Percentile, HasTheRankedLimitsAtSharedLevels) {
  // Rank 2 of 3, means 12 22 32 with squares 14 24 8: both ends have two points to share 2.5 %.
  const double half_width = kT3_0125 * std::sqrt(24.0 / 12.0);
  expect_estimate(metric_of(three_points(), Metric::percentile, 50), 22 - half_width, 22,
                  22 + half_width);
}

TEST(Percentile, EndsAtMinimumAndMaximum) {
  const PointValues values = three_points();
  const calc::Estimate minimum = metric_of(values, Metric::minimum);
  const calc::Estimate maximum = metric_of(values, Metric::maximum);
  expect_estimate(metric_of(values, Metric::percentile, 0), minimum.low, minimum.value,
                  minimum.high);
  expect_estimate(metric_of(values, Metric::percentile, 100), maximum.low, maximum.value,
                  maximum.high);
}

// With halved replicates the limits of the minimum are not those of a rank.
TEST(Percentile, EndsAtMinimumAndMaximumOfManyPoints) {
  std::vector<double> means = bright_plane(200);
  means[17] = 100.0;
  means[18] = 300.0;
  const PointValues values = halves(means, means);
  EXPECT_EQ(metric_of(values, Metric::percentile, 0).high, metric_of(values, Metric::minimum).high);
  EXPECT_EQ(metric_of(values, Metric::percentile, 100).low, metric_of(values, Metric::maximum).low);
}

TEST(PointEstimates, AreTIntervalsWithoutNegativeIlluminance) {
  const PointValues values{2, 4, {10, 0, 12, 1, 11, 0, 15, 1}};
  const std::vector<calc::Estimate> estimates = point_estimates(values, 0.95);
  ASSERT_EQ(estimates.size(), 2u);
  const double half_width = kT3_025 * std::sqrt(14.0 / 12.0);
  expect_estimate(estimates[0], 12 - half_width, 12, 12 + half_width);
  expect_estimate(estimates[1], 0.0, 0.5, 0.5 + kT3_025 * std::sqrt(1.0 / 12.0));
}

TEST(Confidence, WidensEveryInterval) {
  const PointValues values = three_points();
  for (const Metric metric :
       {Metric::average, Metric::minimum, Metric::maximum, Metric::uniformity_min_avg,
        Metric::uniformity_min_max, Metric::percentile}) {
    const auto wide = compute_metric(values, metric, 50, {}, 0.9)->estimate;
    const auto narrow = compute_metric(values, metric, 50, {}, 0.8)->estimate;
    EXPECT_LT(narrow.high - narrow.low, wide.high - wide.low) << calc::name_of(metric);
  }
}

}  // namespace
}  // namespace rules::metrics_test
