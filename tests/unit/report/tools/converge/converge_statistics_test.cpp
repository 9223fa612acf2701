#include "report/tools/converge/converge_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace report::converge_statistics_test {
namespace {

std::vector<double> powers(double first, double exponent, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(first * std::pow(2.0, exponent * static_cast<double>(i)));
  }
  return values;
}

TEST(ConvergeSlope, FindsTheExponent) {
  const std::vector<double> x = powers(0.01, 1.0, 6);
  EXPECT_NEAR(*fitted_exponent(x, powers(0.3, -0.5, 6)), -0.5, 1e-12);
  EXPECT_NEAR(*fitted_exponent(x, powers(0.3, -0.71, 6)), -0.71, 1e-12);
  // Ups and downs that cancel.
  std::vector<double> y = powers(0.3, -0.5, 4);
  y[0] *= 1.1, y[1] /= 1.1, y[2] /= 1.1, y[3] *= 1.1;
  EXPECT_NEAR(*fitted_exponent(powers(1, 1, 4), y), -0.5, 1e-12);
}

TEST(ConvergeSlope, PassesOverWhatIsNotKnown) {
  const double nan = std::nan("");
  EXPECT_NEAR(*fitted_exponent(std::vector<double>{1, 2, 4, 8}, std::vector<double>{8, nan, 2, 1}),
              -1.0, 1e-12);
  EXPECT_FALSE(fitted_exponent(std::vector<double>{1, 2, 4}, std::vector<double>{8, nan, 2}));
  EXPECT_FALSE(fitted_exponent(std::vector<double>{1, 2, 4}, std::vector<double>{8, 0, 2}));
  EXPECT_FALSE(fitted_exponent(std::vector<double>{3, 3, 3}, std::vector<double>{8, 4, 2}));
}

TEST(ConvergeTime, InterpolatesAndSaysWhenItExtrapolates) {
  const std::vector<double> x{1, 4, 16, 64}, y{0.08, 0.04, 0.02, 0.01};
  const ConvergeTarget inside = find_crossing(x, y, 0.0282842712474619);
  ASSERT_TRUE(inside.seconds);
  EXPECT_NEAR(*inside.seconds, 8.0, 1e-9);
  EXPECT_FALSE(inside.is_extrapolated);
  EXPECT_NEAR(*find_crossing(x, y, 0.02).seconds, 16.0, 1e-9);
  const ConvergeTarget beyond = find_crossing(x, y, 0.005);
  ASSERT_TRUE(beyond.seconds);
  EXPECT_NEAR(*beyond.seconds, 256.0, 1e-6);
  EXPECT_TRUE(beyond.is_extrapolated);
  const ConvergeTarget before = find_crossing(x, y, 0.16);
  EXPECT_NEAR(*before.seconds, 0.25, 1e-9);
  EXPECT_TRUE(before.is_extrapolated);
  EXPECT_FALSE(find_crossing(x, y, 0.001).seconds);  // ten times less than measured
}

TEST(ConvergeTime, CountsFromWhereTheErrorStaysSmall) {
  // A lucky step does not count.
  const ConvergeTarget target = find_crossing(std::vector<double>{1, 2, 4, 8},
                                              std::vector<double>{0.1, 0.01, 0.04, 0.01}, 0.02);
  EXPECT_NEAR(*target.seconds, 4.0 * std::sqrt(2.0), 1e-9);
}

TEST(ConvergeTime, AFloorIsNeverReached) {
  const std::vector<double> x{1, 2, 4, 8, 16, 32, 64};
  // A bias of 3 %: all steps together still seem to fall.
  const std::vector<double> y{0.2, 0.1, 0.05, 0.03, 0.029, 0.031, 0.03};
  ASSERT_LT(*fitted_exponent(x, y), -0.4);
  EXPECT_FALSE(find_crossing(x, y, 0.02).seconds);
  EXPECT_TRUE(find_crossing(x, y, 0.07).seconds);
  EXPECT_FALSE(
      find_crossing(std::vector<double>{1, 2, 4, 8}, std::vector<double>{0.1, 0.1, 0.1, 0.1}, 0.05)
          .seconds);
}

TEST(ConvergeErrors, AreWhatTheySay) {
  const ConvergeTruth truth = truth_of({100.0, 200.0, 300.0, 0.0}, {0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(truth.average_lx, 150.0);
  EXPECT_EQ(truth.uo, 0.0);
  const auto errors = errors_of(std::vector<double>{110.0, 200.0, 240.0, 50.0}, truth);
  EXPECT_NEAR(errors[0], std::sqrt((0.01 + 0.0 + 0.04) / 3.0), 1e-12);  // the dark point left out
  EXPECT_NEAR(errors[1], 0.2, 1e-12);
  EXPECT_NEAR(errors[2], 0.0, 1e-12);
  EXPECT_TRUE(std::isnan(errors[3]));  // relative to 0
  const ConvergeTruth lit = truth_of({100.0, 300.0}, {0.0, 0.0});
  EXPECT_NEAR(errors_of(std::vector<double>{110.0, 290.0}, lit)[3], 0.1, 1e-12);
}

TEST(ConvergeTruth, KnowsItsOwnError) {
  // Two points that err together: the average errs as they do.
  const ConvergeTruth truth = truth_of({{90, 180}, {100, 200}, {110, 220}});
  EXPECT_NEAR(truth.error_lx[0], 10.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(truth.average_error_lx, 15.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(truth.uo_error, 0.0, 1e-12);  // the ratio never varies
  EXPECT_NEAR(relative_error(truth), 0.1 / std::sqrt(3.0), 1e-12);
  const ConvergeTruth table = truth_of({100.0, 200.0}, {3.0, 4.0});
  EXPECT_NEAR(table.average_error_lx, 2.5, 1e-12);
}

// E (X - T')^2 - var T' = E (X - T)^2, whatever the reference T' happened to be, on average.
TEST(ConvergePool, SubtractsTheReferencesError) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  constexpr std::size_t kPoints = 4000;
  std::vector<double> reference, error(kPoints, 2.0);
  for (std::size_t i = 0; i < kPoints; ++i) reference.push_back(100.0 + 2.0 * normal(random));
  const ConvergeTruth truth = truth_of(reference, error);
  std::vector<double> of_seeds;
  for (int seed = 0; seed < 8; ++seed) {
    std::vector<double> lx;
    for (std::size_t i = 0; i < kPoints; ++i) lx.push_back(100.0 + 3.0 * normal(random));
    of_seeds.push_back(errors_of(lx, truth)[0]);
  }
  EXPECT_NEAR(of_seeds[0], 0.036, 0.001);
  const ConvergeError pooled = pool_errors(ConvergeMetric::rms, of_seeds, truth);
  EXPECT_NEAR(pooled.value, 0.030, 0.0008);
  EXPECT_FALSE(pooled.is_below);
  EXPECT_LE(pooled.low, pooled.high);
  EXPECT_GT(pooled.low, 0.034);  // as measured
  EXPECT_NEAR(pool_errors(ConvergeMetric::maximum, of_seeds, truth).value, of_seeds[0], 0.001);
}

TEST(ConvergePool, SaysWhatDrownsInTheReferencesError) {
  const ConvergeTruth truth = truth_of({100.0, 100.0}, {2.0, 2.0});
  const std::vector<double> same{0.0201, 0.0199};
  const ConvergeError pooled = pool_errors(ConvergeMetric::rms, same, truth);
  EXPECT_TRUE(pooled.is_below);
  EXPECT_NEAR(pooled.value, 0.02, 1e-12);
  const ConvergeTruth exact = truth_of({100.0, 100.0}, {0.0, 0.0});
  EXPECT_FALSE(pool_errors(ConvergeMetric::rms, same, exact).is_below);
  EXPECT_FALSE(pool_errors(ConvergeMetric::rms, std::vector<double>{0.0}, exact).is_below);
  EXPECT_TRUE(std::isnan(
      pool_errors(ConvergeMetric::rms, std::vector<double>{0.1, std::nan("")}, exact).value));
}

// Normal replicates: t-intervals hold the truth in 95 of 100 cases, and shifted ones do not.
TEST(ConvergeCoverage, CountsWhatHolds) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  constexpr std::size_t kPoints = 20000;
  std::vector<std::vector<double>> replicates(8, std::vector<double>(kPoints));
  for (auto& replicate : replicates) {
    for (double& lx : replicate) lx = 100.0 + 5.0 * normal(random);
  }
  const std::vector<double> exact(kPoints, 0.0);
  const auto share = [&](double lx, const std::vector<double>& error) {
    return coverage_of(replicates, truth_of(std::vector<double>(kPoints, lx), error), 0.95);
  };
  EXPECT_EQ(share(100.0, exact).tried, kPoints);
  EXPECT_NEAR(share(100.0, exact).share(), 0.95, 0.006);  // 4 standard errors
  EXPECT_LT(share(106.0, exact).share(), 0.3);
  EXPECT_GT(share(106.0, std::vector<double>(kPoints, 5.0)).share(), 0.95);
  const ConvergeTruth truth = truth_of(std::vector<double>(kPoints, 100.0), exact);
  EXPECT_EQ(average_coverage_of(replicates, truth, 0.95).tried, 1u);
  EXPECT_EQ(average_coverage_of(replicates, truth, 0.95).held, 1u);
  EXPECT_EQ(
      average_coverage_of(replicates, truth_of(std::vector<double>(kPoints, 101.0), exact), 0.95)
          .held,
      0u);
}

TEST(ConvergeCoverage, LeavesOutWhatNeverVaries) {
  const std::vector<std::vector<double>> fixed(4, std::vector<double>{7.0, 8.0});
  EXPECT_EQ(coverage_of(fixed, truth_of({7.0, 9.0}, {0.0, 0.0}), 0.95).tried, 0u);
}

TEST(ConvergeMedian, OfOddAndEvenCounts) {
  EXPECT_EQ(median({3, 1, 2}), 2.0);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median({5}), 5.0);
}

}  // namespace
}  // namespace report::converge_statistics_test
