#include "rules/measure/share.h"

#include "tests/support/normal_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rules::share_test {
namespace {

using testing::ElementsAre;

PointValues exact(std::vector<double> values) {
  const std::size_t points = values.size();
  return PointValues{points, 1, std::move(values)};
}

// Two points, four replicates: one well known around 100, the other anywhere around 300.
PointValues noisy() { return PointValues{2, 4, {100, 200, 101, 400, 100, 250, 101, 350}}; }

double share_of(const PointValues& values, const ValueRange& range) {
  return compute_share(values, range, 0.95).estimate.value;
}

TEST(Share, CountsPointsFromOneEndToTheOther) {
  const PointValues values = exact({100, 200, 300, 400});
  EXPECT_EQ(share_of(values, {200, 300}), 0.5);  // both ends belong to it
  EXPECT_EQ(share_of(values, {201}), 0.5);
  EXPECT_EQ(share_of(values, {0, 100}), 0.25);
  EXPECT_EQ(share_of(values, {500}), 0.0);
}

TEST(Share, OfExactValuesIsExact) {
  const ShareEstimate share = compute_share(exact({100, 200, 300, 400}), {250}, 0.95);
  EXPECT_EQ(share.estimate.low, 0.5);
  EXPECT_EQ(share.estimate.high, 0.5);
  EXPECT_THAT(share.open, ElementsAre(0, 0, 0, 0));
}

TEST(Share, LeavesOpenWhatMayLieOnEitherSide) {
  const ShareEstimate share = compute_share(noisy(), {280}, 0.95);
  EXPECT_EQ(share.estimate.value, 0.5);
  EXPECT_EQ(share.estimate.low, 0.0);
  EXPECT_EQ(share.estimate.high, 0.5);
  EXPECT_THAT(share.open, ElementsAre(0, 1));
}

TEST(Share, OfANarrowRangeBetweenTheLimitsIsPossible) {
  const ShareEstimate share = compute_share(noisy(), {290, 291}, 0.95);
  EXPECT_EQ(share.estimate.value, 0.0);
  EXPECT_EQ(share.estimate.high, 0.5);
}

TEST(Share, LeavesDoubtfulPointsOpen) {
  PointValues values{2, 4, {100, 0, 101, 0, 100, 0, 101, 0}};
  EXPECT_EQ(compute_share(values, {50}, 0.95).estimate.high, 0.5);
  values.unseen = {0, 1};
  const ShareEstimate unseen = compute_share(values, {50}, 0.95);
  EXPECT_EQ(unseen.estimate.low, 0.5);
  EXPECT_EQ(unseen.estimate.high, 1.0);
  EXPECT_THAT(unseen.open, ElementsAre(0, 1));
  values.unseen.clear();
  values.largest_share = {0.5F, 0.0F};
  EXPECT_EQ(compute_share(values, {50}, 0.95).estimate.low, 0.0);
}

// 30 points next to the end of the range, 500 experiments: the interval misses the truth at most as
// often as it may, and is not all of [0, 1].
TEST(Share, IntervalHoldsTheTruth) {
  constexpr std::size_t kPoints = 30, kReplicates = 16;
  NormalNumbers normal(7);
  int misses = 0;
  double width = 0.0;
  for (int experiment = 0; experiment < 500; ++experiment) {
    PointValues values{kPoints, kReplicates, {}};
    for (std::size_t r = 0; r < kReplicates; ++r) {
      const double shared = 3.0 * normal.next();
      for (std::size_t i = 0; i < kPoints; ++i) {
        values.value_lx.push_back(286.0 + static_cast<double>(i) + shared + 3.0 * normal.next());
      }
    }
    const calc::Estimate estimate = compute_share(values, {300.5}, 0.95).estimate;
    if (estimate.low > 0.5 || estimate.high < 0.5) ++misses;
    width += (estimate.high - estimate.low) / 500.0;
  }
  EXPECT_LE(misses, 25);
  EXPECT_LT(width, 0.5);
  EXPECT_GT(width, 0.1);
}

}  // namespace
}  // namespace rules::share_test
