#include "rules/measure/candidates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rules::candidates_test {
namespace {

using ::testing::ElementsAre;

// Four replicates per point: mean - spread, mean + spread, twice, so that the standard error is
// spread / sqrt(3); at 95 % the half-width is 3.182 of them, 1.837 spreads. Odd points swing
// against even ones, so that the plane's average is quiet.
PointValues values_of(const std::vector<double>& mean_lx, const std::vector<double>& spread_lx) {
  PointValues values{mean_lx.size(), 4, {}};
  for (const double sign : {-1.0, 1.0, -1.0, 1.0}) {
    for (std::size_t i = 0; i < mean_lx.size(); ++i) {
      values.value_lx.push_back(mean_lx[i] + (i % 2 == 0 ? sign : -sign) * spread_lx[i]);
    }
  }
  return values;
}

Candidates candidates(const PointValues& values, Metric metric, std::optional<double> limit = {},
                      double percent = 0.0, std::optional<std::size_t> point = {}) {
  const calc::Estimate estimate =
      compute_metric(values, metric, percent, point, 0.95).value().estimate;
  return find_candidates(values, metric, percent, point, estimate, limit, 0.95);
}

// Intervals 100 -+ 18.4, 110 -+ 18.4, 200 -+ 18.4, 400 exactly; the minimum ends at 100 + 5.5 * ...
// < 181.
TEST(Candidates, OfTheMinimumMayLieBelowItsUpperLimit) {
  const PointValues values = values_of({100, 110, 200, 400}, {10, 10, 10, 0});
  EXPECT_THAT(candidates(values, Metric::minimum).active, ElementsAre(1, 1, 0, 0));
  EXPECT_THAT(candidates(values, Metric::percentile).active, ElementsAre(1, 1, 0, 0));
}

// 91.6 < 95 < 118.4: point 1 can neither break nor save "at least 90".
TEST(Candidates, ForAVerdictMayLieBelowTheLimit) {
  const PointValues values = values_of({100, 110, 200, 400}, {10, 10, 10, 0});
  EXPECT_THAT(candidates(values, Metric::minimum, 90.0).active, ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(candidates(values, Metric::minimum, 95.0).active, ElementsAre(1, 1, 0, 0));
  EXPECT_THAT(candidates(values, Metric::minimum, 1000.0).active, ElementsAre(1, 1, 0, 0));
}

TEST(Candidates, OfTheMaximumAreMirrored) {
  const PointValues values = values_of({100, 300, 310, 320}, {10, 10, 10, 0});
  EXPECT_THAT(candidates(values, Metric::maximum).active, ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(candidates(values, Metric::percentile, {}, 100.0).active, ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(candidates(values, Metric::maximum, 325.0).active, ElementsAre(0, 0, 1, 0));
}

TEST(Candidates, OfUdAreThoseOfBothEnds) {
  const PointValues values = values_of({100, 200, 210, 300}, {1, 1, 1, 1});
  EXPECT_THAT(candidates(values, Metric::uniformity_min_max).active, ElementsAre(1, 0, 0, 1));
}

TEST(Candidates, OfAverageAndPercentileAreAllPoints) {
  const PointValues values = values_of({100, 200, 300, 400}, {1, 1, 1, 1});
  EXPECT_THAT(candidates(values, Metric::average).active, ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(candidates(values, Metric::percentile, {}, 50.0).active, ElementsAre(1, 1, 1, 1));
}

TEST(Candidates, OfAValueIsItsPoint) {
  const PointValues values = values_of({100, 200, 300, 400}, {1, 1, 1, 1});
  EXPECT_THAT(candidates(values, Metric::value_at_point, 150.0, 0.0, 2).active,
              ElementsAre(0, 0, 1, 0));
}

// Mean 200: ratios 0.5 -+ 0.0092, 0.75, 1.25, 1.5; noise of the points cancels in the average.
TEST(Candidates, OfUoStraddleTheLimit) {
  const PointValues values = values_of({100, 150, 250, 300}, {1, 1, 1, 1});
  EXPECT_THAT(candidates(values, Metric::uniformity_min_avg, 0.5).active, ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(candidates(values, Metric::uniformity_min_avg).active, ElementsAre(1, 0, 0, 0));
}

// Point 0 is quiet, points 2 and 3 swing together: u * mean(E) is nearly all of the noise of
// E_0 - u * mean(E), which more samples at point 0 cannot reduce.
TEST(Candidates, OfUoAreAllPointsIfTheAverageIsTheNoise) {
  PointValues values = values_of({100, 150, 250, 300}, {0.1, 0, 0, 0});
  for (std::size_t r = 0; r < 4; ++r) {
    values.value_lx[4 * r + 2] += r < 2 ? 20.0 : -20.0;
    values.value_lx[4 * r + 3] += r < 2 ? 20.0 : -20.0;
  }
  const Candidates found = candidates(values, Metric::uniformity_min_avg, 0.5);
  EXPECT_THAT(found.active, ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(found.matters, ElementsAre(1, 0, 0, 0));
}

// 200 -+ 1.8 lx would be far from the minimum, but half of it is one sample.
TEST(Candidates, APointThatRestsOnOneSampleMayBeLowerByIt) {
  PointValues values = values_of({110, 200, 300, 400}, {1, 1, 1, 1});
  values.largest_share = {0.0F, 0.5F, 0.05F, 0.5F};
  const Candidates found = candidates(values, Metric::minimum);
  EXPECT_THAT(found.matters, ElementsAre(1, 1, 0, 0));
  EXPECT_EQ(count_doubtful(values, Metric::minimum, found.matters).single_sample, 1u);
}

TEST(Candidates, APointThatRestsOnOneSampleMayBeHigherByIt) {
  PointValues values = values_of({100, 150, 300, 400}, {1, 1, 1, 1});
  values.largest_share = {0.5F, 0.05F, 0.5F, 0.05F};
  const Candidates found = candidates(values, Metric::maximum);
  EXPECT_THAT(found.matters, ElementsAre(0, 0, 1, 1));
  EXPECT_EQ(count_doubtful(values, Metric::maximum, found.matters).single_sample, 1u);
}

TEST(Candidates, AShareOfOneTenthIsStillTrusted) {
  PointValues values = values_of({100, 200, 300, 400}, {1, 1, 1, 1});
  values.largest_share = {0.1F, 0.1F, 0.1F, 0.1F};
  const Candidates found = candidates(values, Metric::minimum);
  EXPECT_EQ(count_doubtful(values, Metric::minimum, found.matters).single_sample, 0u);
}

// The sample is 0.5 * 100 of 1000 lx: 5 % of the average; at the last point 0.5 * 400: 20 %.
TEST(Candidates, TheAverageRestsOnASampleThatIsALargeShareOfIt) {
  PointValues values = values_of({100, 200, 300, 400}, {1, 1, 1, 1});
  values.largest_share = {0.5F, 0.0F, 0.0F, 0.0F};
  for (const Metric metric : {Metric::average, Metric::uniformity_min_avg}) {
    values.largest_share = {0.0F, 0.2F, 0.0F, 0.0F};
    EXPECT_EQ(count_doubtful(values, metric, candidates(values, metric).matters).single_sample, 0u);
    values.largest_share = {0.0F, 0.0F, 0.0F, 0.5F};
    EXPECT_EQ(count_doubtful(values, metric, candidates(values, metric).matters).single_sample, 1u);
  }
}

// What was seen of an unseen point is exact: a lower bound, but no upper one.
TEST(Candidates, UnseenPointsCountWhereTheyMayBeTheExtreme) {
  PointValues values = values_of({0, 100, 200, 150}, {0, 1, 1, 0});
  values.unseen = {1, 0, 0, 1};
  const auto unseen = [&values](Metric metric, std::optional<double> limit) {
    return count_doubtful(values, metric, candidates(values, metric, limit).matters).unseen;
  };
  EXPECT_EQ(unseen(Metric::minimum, 50.0), 1u);
  EXPECT_EQ(unseen(Metric::uniformity_min_avg, 0.5), 1u);
  EXPECT_EQ(unseen(Metric::maximum, 500.0), 2u);
  EXPECT_EQ(unseen(Metric::percentile, 50.0), 1u);  // percentile 0, the minimum
  EXPECT_EQ(unseen(Metric::average, 50.0), 0u);
  values.unseen = {1, 1, 1, 1};
  EXPECT_EQ(unseen(Metric::average, 50.0), 4u);
}

}  // namespace
}  // namespace rules::candidates_test
