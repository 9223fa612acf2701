#include "rules/compare.h"

#include <gtest/gtest.h>

namespace rules {
namespace {

constexpr Comparison kAtLeast = Comparison::at_least;
constexpr Comparison kAtMost = Comparison::at_most;

calc::Estimate interval(double low, double high) { return {0.5 * (low + high), low, high}; }

TEST(Meets, TakesTheLimitItself) {
  EXPECT_TRUE(meets(500.0, kAtLeast, 500.0));
  EXPECT_TRUE(meets(500.0, kAtMost, 500.0));
  EXPECT_TRUE(meets(0.0, kAtMost, 0.0));
}

TEST(Meets, AbsorbsBinaryNoiseAndNothingMore) {
  EXPECT_TRUE(meets(0.1 + 0.2 - 1e-16, kAtLeast, 0.1 + 0.2));
  EXPECT_TRUE(meets(500.0 - 4e-7, kAtLeast, 500.0));
  EXPECT_FALSE(meets(500.0 - 6e-7, kAtLeast, 500.0));
  EXPECT_TRUE(meets(500.0 + 4e-7, kAtMost, 500.0));
  EXPECT_FALSE(meets(500.0 + 6e-7, kAtMost, 500.0));
  EXPECT_FALSE(meets(1e-300, kAtMost, 0.0));
}

TEST(Compare, PassesOnlyWithTheWholeInterval) {
  EXPECT_EQ(compare(interval(501, 520), kAtLeast, 500), Verdict::pass);
  EXPECT_EQ(compare(interval(480, 499), kAtLeast, 500), Verdict::fail);
  EXPECT_EQ(compare(interval(492, 508), kAtLeast, 500), Verdict::undecided);
  EXPECT_EQ(compare(interval(480, 499), kAtMost, 500), Verdict::pass);
  EXPECT_EQ(compare(interval(501, 520), kAtMost, 500), Verdict::fail);
  EXPECT_EQ(compare(interval(492, 508), kAtMost, 500), Verdict::undecided);
}

TEST(Compare, TakesALimitOnAnEndOfTheInterval) {
  EXPECT_EQ(compare(interval(500, 520), kAtLeast, 500), Verdict::pass);
  EXPECT_EQ(compare(interval(480, 500), kAtLeast, 500), Verdict::undecided);  // 500 itself would do
  EXPECT_EQ(compare(interval(480, 500), kAtMost, 500), Verdict::pass);
  EXPECT_EQ(compare(interval(500, 520), kAtMost, 500), Verdict::undecided);
}

TEST(Compare, OfAnExactValueIsNeverUndecided) {
  EXPECT_EQ(compare(interval(500, 500), kAtLeast, 500), Verdict::pass);
  EXPECT_EQ(compare(interval(499.9, 499.9), kAtLeast, 500), Verdict::fail);
}

TEST(Margin, IsPositiveOnTheGoodSide) {
  EXPECT_DOUBLE_EQ(margin(550, kAtLeast, 500), 0.1);
  EXPECT_DOUBLE_EQ(margin(450, kAtLeast, 500), -0.1);
  EXPECT_DOUBLE_EQ(margin(450, kAtMost, 500), 0.1);
  EXPECT_DOUBLE_EQ(margin(550, kAtMost, 500), -0.1);
}

TEST(Margin, OfALimitOfZeroIsZero) {
  EXPECT_EQ(margin(7, kAtLeast, 0), 0.0);
  EXPECT_EQ(margin(7, kAtMost, 0), 0.0);
}

TEST(RoundAsPrinted, IsHalfUpToWholeLuxAndTwoDigitsOfARatio) {
  EXPECT_EQ(round_as_printed(499.5, Metric::average), 500.0);
  EXPECT_EQ(round_as_printed(499.49, Metric::average), 499.0);
  EXPECT_EQ(round_as_printed(0.595, Metric::uniformity_min_avg), 0.60);
  EXPECT_EQ(round_as_printed(0.285, Metric::uniformity_min_max), 0.29);
  EXPECT_EQ(round_as_printed(0.594, Metric::uniformity_min_avg), 0.59);
}

TEST(CloseCall, IsAVerdictThatRoundingWouldTurn) {
  EXPECT_TRUE(is_close_call(499.6, Metric::average, kAtLeast, 500));
  EXPECT_FALSE(is_close_call(499.4, Metric::average, kAtLeast, 500));
  EXPECT_FALSE(is_close_call(500.4, Metric::average, kAtLeast, 500));
  EXPECT_TRUE(is_close_call(500.4, Metric::maximum, kAtMost, 500));
  EXPECT_TRUE(is_close_call(0.595, Metric::uniformity_min_avg, kAtLeast, 0.60));
  EXPECT_FALSE(is_close_call(0.594, Metric::uniformity_min_avg, kAtLeast, 0.60));
}

TEST(VerdictName, IsInWords) {
  EXPECT_STREQ(verdict_name(Verdict::pass), "pass");
  EXPECT_STREQ(verdict_name(Verdict::fail), "fail");
  EXPECT_STREQ(verdict_name(Verdict::undecided), "undecided");
  EXPECT_STREQ(verdict_name(Verdict::not_judged), "not judged");
}

}  // namespace
}  // namespace rules
