#include "rules/measure/leave_one_out.h"

#include "calc/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace rules::leave_one_out_test {
namespace {

// [replicate][point], around `mean_lx`; `common` is drawn for all points of a replicate together.
PointValues drawn(const std::vector<double>& mean_lx, std::uint32_t seed, double common = 0.0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  PointValues values{mean_lx.size(), 16, {}};
  for (std::size_t r = 0; r < values.replicates; ++r) {
    const double shift = common * noise(random);
    for (const double mean : mean_lx) values.value_lx.push_back(mean + shift + noise(random));
  }
  return values;
}

std::vector<double> means_without(const PointValues& values, std::size_t left_out) {
  std::vector<double> means(values.points, 0.0);
  for (std::size_t r = 0; r < values.replicates; ++r) {
    if (r == left_out) continue;
    for (std::size_t i = 0; i < values.points; ++i) means[i] += values.at(r, i) / 15.0;
  }
  return means;
}

TEST(LeaveOneOut, IsTheValueOfTheOtherReplicates) {
  const PointValues values = drawn({100, 140, 90, 200, 160}, 3);
  PointValues others{values.points, 15, {}};
  others.value_lx.assign(values.value_lx.begin() + 5, values.value_lx.end());
  for (const Metric metric : {Metric::average, Metric::minimum, Metric::maximum,
                              Metric::uniformity_min_avg, Metric::uniformity_min_max}) {
    const double expected = compute_metric(others, metric, 0.0, std::nullopt, 0.95)->estimate.value;
    EXPECT_NEAR(without_each_replicate(values, metric, 0.0, std::nullopt).at(0), expected,
                1e-12 * expected)
        << calc::name_of(metric);
  }
  const double expected =
      compute_metric(others, Metric::percentile, 40.0, std::nullopt, 0.95)->estimate.value;
  EXPECT_NEAR(without_each_replicate(values, Metric::percentile, 40.0, std::nullopt).at(0),
              expected, 1e-12 * expected);
  EXPECT_NEAR(without_each_replicate(values, Metric::value_at_point, 0.0, 3).at(7),
              means_without(values, 7)[3], 1e-10);
}

TEST(LeaveOneOut, WeighsPointsAsTheAverageDoes) {
  PointValues values = drawn({100, 300}, 5);
  values.weight = {3, 1};
  const std::vector<double> means = means_without(values, 0);
  EXPECT_NEAR(without_each_replicate(values, Metric::average, 0.0, std::nullopt).at(0),
              0.75 * means[0] + 0.25 * means[1], 1e-10);
}

TEST(LeaveOneOut, OfExactOrUndefinedValuesThereIsNone) {
  EXPECT_TRUE(without_each_replicate({2, 1, {5, 6}}, Metric::average, 0.0, std::nullopt).empty());
  const PointValues dark{1, 2, {0, 0}};
  EXPECT_TRUE(without_each_replicate(dark, Metric::uniformity_min_avg, 0.0, std::nullopt).empty());
  EXPECT_TRUE(without_each_replicate(drawn({1}, 1), Metric::share, 0.0, std::nullopt).empty());
}

TEST(LeaveOneOut, OfAnyStatisticIsWhatTheOthersGive) {
  const PointValues values = drawn({100, 140, 90, 200, 160}, 3);
  const auto minimum = [](const PointValues& of) -> std::optional<double> {
    return compute_metric(of, Metric::minimum, 0.0, std::nullopt, 0.95)->estimate.value;
  };
  const auto expected = without_each_replicate(values, Metric::minimum, 0.0, std::nullopt);
  const auto found = without_each_replicate(values, minimum);
  ASSERT_EQ(found.size(), 16u);
  for (std::size_t r = 0; r < 16; ++r) EXPECT_NEAR(found[r], expected[r], 1e-12 * expected[r]);
  EXPECT_TRUE(without_each_replicate({2, 1, {5, 6}}, minimum).empty());
  const auto none = [](const PointValues&) { return std::optional<double>(); };
  EXPECT_TRUE(without_each_replicate(values, none).empty());
}

// Of averages the jackknife is the t interval of the replicates' differences.
TEST(PairedDifference, OfAveragesIsTheIntervalOfTheDifferences) {
  const PointValues a = drawn({100, 120, 90}, 7), b = drawn({101, 119, 92}, 8);
  std::vector<double> differences;
  for (std::size_t r = 0; r < 16; ++r) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += (b.at(r, i) - a.at(r, i)) / 3.0;
    differences.push_back(sum);
  }
  const calc::Estimate exact = calc::t_interval(differences, 0.95);
  const calc::Estimate found = paired_difference(
      without_each_replicate(a, Metric::average, 0.0, std::nullopt),
      without_each_replicate(b, Metric::average, 0.0, std::nullopt), exact.value, 0.95);
  EXPECT_NEAR(found.low, exact.low, 1e-9);
  EXPECT_NEAR(found.high, exact.high, 1e-9);
}

// What both share goes out of the interval, and the rest holds the truth as often as it says.
TEST(PairedDifference, HoldsTheTruthAsOftenAsItSays) {
  constexpr int kRuns = 2000;
  for (const Metric metric : {Metric::average, Metric::uniformity_min_avg}) {
    int held = 0;
    double widest = 0.0;
    for (int run = 0; run < kRuns; ++run) {
      const PointValues a = drawn({100, 140, 160}, static_cast<std::uint32_t>(run), 20.0);
      PointValues b = a;  // the same draws, with noise of its own
      std::mt19937 random(static_cast<std::uint32_t>(run) + 100'000);
      std::normal_distribution<double> noise(0.0, 1.0);
      for (double& lx : b.value_lx) lx = 0.9 * lx + noise(random);
      const auto value = [&](const PointValues& values) {
        return compute_metric(values, metric, 0.0, std::nullopt, 0.95)->estimate.value;
      };
      const calc::Estimate found = paired_difference(
          without_each_replicate(a, metric, 0.0, std::nullopt),
          without_each_replicate(b, metric, 0.0, std::nullopt), value(b) - value(a), 0.95);
      const double truth = metric == Metric::average ? -0.1 * 400.0 / 3.0 : 0.0;
      held += found.low <= truth && truth <= found.high ? 1 : 0;
      widest = std::max(widest, found.half_width());
    }
    EXPECT_NEAR(held, 0.95 * kRuns, 0.02 * kRuns) << calc::name_of(metric);
    if (metric == Metric::average) {
      EXPECT_LT(widest, 4.0);  // alone +-11
    }
  }
}

}  // namespace
}  // namespace rules::leave_one_out_test
