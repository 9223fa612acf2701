#include "rules/catalogue/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rules::compare_test {
namespace {

constexpr Comparison kAtLeast = Comparison::at_least;
constexpr Comparison kAtMost = Comparison::at_most;

constexpr Comparison kMoreThan = Comparison::more_than;
constexpr Comparison kLessThan = Comparison::less_than;

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

TEST(Meets, LeavesTheLimitItselfOutOfAnExclusiveOne) {
  EXPECT_FALSE(meets(500.0, kMoreThan, 500.0));
  EXPECT_FALSE(meets(500.0 + 4e-7, kMoreThan, 500.0));
  EXPECT_TRUE(meets(500.001, kMoreThan, 500.0));
  EXPECT_FALSE(meets(500.0, kLessThan, 500.0));
  EXPECT_TRUE(meets(499.999, kLessThan, 500.0));
}

Decision decision_of(calc::Estimate measured, Comparison comparison, calc::Estimate limit,
                     const DecisionPolicy& policy = {}, int digits = 0) {
  return decide({measured, comparison, limit, digits}, policy);
}

Verdict verdict_of(calc::Estimate measured, Comparison comparison, double limit) {
  return decision_of(measured, comparison, {limit, limit, limit}).verdict;
}

TEST(Decide, PassesOnlyWithTheWholeInterval) {
  EXPECT_EQ(verdict_of(interval(501, 520), kAtLeast, 500), Verdict::pass);
  EXPECT_EQ(verdict_of(interval(480, 499), kAtLeast, 500), Verdict::fail);
  EXPECT_EQ(verdict_of(interval(492, 508), kAtLeast, 500), Verdict::undecided);
  EXPECT_EQ(verdict_of(interval(480, 499), kAtMost, 500), Verdict::pass);
  EXPECT_EQ(verdict_of(interval(501, 520), kAtMost, 500), Verdict::fail);
  EXPECT_EQ(verdict_of(interval(492, 508), kAtMost, 500), Verdict::undecided);
}

TEST(Decide, TakesALimitOnAnEndOfTheInterval) {
  EXPECT_EQ(verdict_of(interval(500, 520), kAtLeast, 500), Verdict::pass);
  EXPECT_EQ(verdict_of(interval(480, 500), kAtLeast, 500), Verdict::undecided);  // 500 would do
  EXPECT_EQ(verdict_of(interval(480, 500), kAtMost, 500), Verdict::pass);
  EXPECT_EQ(verdict_of(interval(500, 520), kAtMost, 500), Verdict::undecided);
  EXPECT_EQ(verdict_of(interval(500, 520), kMoreThan, 500), Verdict::undecided);
}

TEST(Decide, OfAnExactValueIsNeverUndecided) {
  EXPECT_EQ(verdict_of(interval(500, 500), kAtLeast, 500), Verdict::pass);
  EXPECT_EQ(verdict_of(interval(499.9, 499.9), kAtLeast, 500), Verdict::fail);
}

TEST(Decide, AgainstALimitThatIsAnIntervalItself) {
  const calc::Estimate limit = interval(90, 110);
  EXPECT_EQ(decision_of(interval(111, 120), kAtLeast, limit).verdict, Verdict::pass);
  EXPECT_EQ(decision_of(interval(70, 89), kAtLeast, limit).verdict, Verdict::fail);
  EXPECT_EQ(decision_of(interval(100, 120), kAtLeast, limit).verdict, Verdict::undecided);
  EXPECT_EQ(decision_of(interval(95, 95), kAtLeast, limit).verdict, Verdict::undecided);
}

// 499.6 lx against 500 lx under four policies.
TEST(Decide, DoesWhatThePolicySays) {
  const calc::Estimate value = interval(499.6, 499.6);
  const calc::Estimate limit = interval(500, 500);
  const Decision strict = decision_of(value, kAtLeast, limit);
  EXPECT_EQ(strict.verdict, Verdict::fail);
  EXPECT_TRUE(strict.is_close);

  DecisionPolicy rounded;
  rounded.compares_rounded = true;
  EXPECT_EQ(decision_of(value, kAtLeast, limit, rounded).verdict, Verdict::pass);
  EXPECT_TRUE(decision_of(value, kAtLeast, limit, rounded).is_close);  // only by rounding

  DecisionPolicy tolerant;
  tolerant.tolerance = 0.01;
  const Decision by_tolerance = decision_of(value, kAtLeast, limit, tolerant);
  EXPECT_EQ(by_tolerance.verdict, Verdict::pass);
  EXPECT_TRUE(by_tolerance.by_tolerance);
  EXPECT_FALSE(decision_of(interval(505, 505), kAtLeast, limit, tolerant).by_tolerance);
  EXPECT_EQ(decision_of(interval(494, 494), kAtLeast, limit, tolerant).verdict, Verdict::fail);
  EXPECT_EQ(decision_of(interval(504, 504), kAtMost, limit, tolerant).verdict, Verdict::pass);

  DecisionPolicy guarded;
  guarded.guard = 0.05;
  EXPECT_EQ(decision_of(value, kAtLeast, limit, guarded).verdict, Verdict::undecided);
  EXPECT_EQ(decision_of(interval(530, 530), kAtLeast, limit, guarded).verdict, Verdict::pass);
}

TEST(Decide, FlagsAVerdictThatRoundingWouldTurn) {
  const auto is_close = [](double value, Comparison comparison, double limit, int digits) {
    return decision_of({value, value, value}, comparison, {limit, limit, limit}, {}, digits)
        .is_close;
  };
  EXPECT_TRUE(is_close(499.6, kAtLeast, 500, 0));
  EXPECT_FALSE(is_close(499.4, kAtLeast, 500, 0));
  EXPECT_FALSE(is_close(500.4, kAtLeast, 500, 0));
  EXPECT_TRUE(is_close(500.4, kAtMost, 500, 0));
  EXPECT_TRUE(is_close(0.595, kAtLeast, 0.60, 2));
  EXPECT_FALSE(is_close(0.594, kAtLeast, 0.60, 2));
}

// Whole lux are not usual at 1 lx: 0.6 lx is printed as 0.60, and 2.4 lx as 2.4.
TEST(Decide, SmallValuesArePrintedWithTwoSignificantDigits) {
  const auto decided = [](double value, Comparison comparison, double limit,
                          const DecisionPolicy& policy = {}) {
    return decision_of({value, value, value}, comparison, {limit, limit, limit}, policy, 0);
  };
  EXPECT_FALSE(decided(0.60, kAtLeast, 1).is_close);
  EXPECT_FALSE(decided(0.99, kAtLeast, 1).is_close);
  EXPECT_TRUE(decided(0.996, kAtLeast, 1).is_close);
  EXPECT_FALSE(decided(2.4, kAtMost, 2).is_close);
  EXPECT_TRUE(decided(2.04, kAtMost, 2).is_close);
  EXPECT_FALSE(decided(9.6, kAtLeast, 10).is_close);
  EXPECT_TRUE(decided(9.96, kAtLeast, 10).is_close);
  EXPECT_TRUE(decided(10.4, kAtMost, 10).is_close);
  EXPECT_FALSE(decided(0.0, kAtLeast, 1).is_close);
  // Nor does a policy of whole lux make 1 lx of them.
  DecisionPolicy rounded;
  rounded.compares_rounded = true;
  EXPECT_EQ(decided(0.6, kAtLeast, 1, rounded).verdict, Verdict::fail);
  EXPECT_EQ(decided(0.996, kAtLeast, 1, rounded).verdict, Verdict::pass);
  EXPECT_EQ(decided(499.6, kAtLeast, 500, rounded).verdict, Verdict::pass);
}

TEST(Margin, IsPositiveOnTheGoodSide) {
  EXPECT_DOUBLE_EQ(margin(550, kAtLeast, 500), 0.1);
  EXPECT_DOUBLE_EQ(margin(450, kAtLeast, 500), -0.1);
  EXPECT_DOUBLE_EQ(margin(450, kAtMost, 500), 0.1);
  EXPECT_DOUBLE_EQ(margin(550, kAtMost, 500), -0.1);
}

TEST(Margin, OfALimitOfZeroThereIsNone) {
  EXPECT_TRUE(std::isnan(margin(7, kAtLeast, 0)));
  EXPECT_TRUE(std::isnan(margin(7, kAtMost, 0)));
}

TEST(RoundTo, HalfUpIsAsWritten) {
  EXPECT_EQ(round_to(499.5, 0, Rounding::half_up), 500.0);
  EXPECT_EQ(round_to(499.49, 0, Rounding::half_up), 499.0);
  EXPECT_EQ(round_to(0.595, 2, Rounding::half_up), 0.60);
  EXPECT_EQ(round_to(0.285, 2, Rounding::half_up), 0.29);
  EXPECT_EQ(round_to(0.594, 2, Rounding::half_up), 0.59);
}

TEST(RoundTo, HalfEvenAndDown) {
  EXPECT_EQ(round_to(2.5, 0, Rounding::half_even), 2.0);
  EXPECT_EQ(round_to(3.5, 0, Rounding::half_even), 4.0);
  EXPECT_EQ(round_to(0.285, 2, Rounding::half_even), 0.28);
  EXPECT_EQ(round_to(2.51, 0, Rounding::half_even), 3.0);
  EXPECT_EQ(round_to(499.99, 0, Rounding::down), 499.0);
  EXPECT_EQ(round_to(0.6, 1, Rounding::down), 0.6);
}

TEST(PolicyText, SaysWhatIsNotUsual) {
  EXPECT_EQ(policy_text({}), "unrounded values, no tolerance");
  DecisionPolicy policy;
  policy.compares_rounded = true;
  policy.tolerance = 0.01;
  policy.tolerance_reason = "contract 4";
  policy.guard = 0.05;
  EXPECT_EQ(policy_text(policy),
            "values rounded (half-up; 0 digits of lx, 2 of ratios, 1 of others), tolerance 1 % of "
            "the limit (contract 4), intervals widened by 5 %");
}

TEST(VerdictName, IsInWords) {
  EXPECT_STREQ(verdict_name(Verdict::pass), "pass");
  EXPECT_STREQ(verdict_name(Verdict::fail), "fail");
  EXPECT_STREQ(verdict_name(Verdict::undecided), "undecided");
  EXPECT_STREQ(verdict_name(Verdict::not_judged), "not judged");
}

// The margin is of the number that stands beside it.
TEST(Margin, IsOfTheEndThatIsKnownWhereTheOtherIsOpen) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  using calc::Estimate;
  EXPECT_DOUBLE_EQ(margin(Estimate{20, 18, 25}, Comparison::at_most, 40), 0.5);
  EXPECT_DOUBLE_EQ(margin(Estimate{20, -kOpen, 30}, Comparison::at_most, 40), 0.25);
  EXPECT_DOUBLE_EQ(margin(Estimate{20, 10, kOpen}, Comparison::at_most, 40), 0.75);
  EXPECT_EQ(margin(Estimate{-kOpen, -kOpen, 30}, Comparison::at_most, 40), kOpen);
}

}  // namespace
}  // namespace rules::compare_test
