#include "report/text/pass_factor.h"

#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

namespace report::pass_factor_test {
namespace {

TEST(PassFactor, IsLimitOverMeasuredWithTheIntervalTurned) {
  const rules::Finding finding = sample_finding(rules::Metric::average, 500, estimate(400, 8));
  const auto factor = pass_factor(finding);
  ASSERT_TRUE(factor);
  EXPECT_DOUBLE_EQ(factor->value, 1.25);
  EXPECT_DOUBLE_EQ(factor->low, 500.0 / 408);
  EXPECT_DOUBLE_EQ(factor->high, 500.0 / 392);
  // With that much light the upper end is proved to pass.
  EXPECT_GE(factor->high * finding.measured.low, 500 - 1e-9);
  EXPECT_EQ(pass_factor_words({}, finding),
            "The flux of all luminaires ×1.28 would reach the limit.");
}

TEST(PassFactor, HasDigitsEnoughForNarrowIntervals) {
  // 353.8 / 353.66 = 1.000396
  EXPECT_EQ(
      pass_factor_words({}, sample_finding(rules::Metric::average, 353.8, estimate(353.70, 0.04))),
      "The flux of all luminaires ×1.0004 would reach the limit.");
}

TEST(PassFactor, LessLightForAnUpperLimit) {
  rules::Finding finding = sample_finding(rules::Metric::maximum, 60, estimate(80, 0));
  finding.requirement.comparison = rules::Comparison::at_most;
  finding.verdict = rules::Verdict::fail;
  EXPECT_EQ(pass_factor_words({}, finding),
            "The flux of all luminaires ×0.75 would meet the limit.");
  // The end that proves it: 60 / 84 = 0.714.
  finding.measured = estimate(80, 4);
  EXPECT_EQ(pass_factor_words({}, finding),
            "The flux of all luminaires ×0.71 would meet the limit.");
}

// An interval of 1 to 60 000 lx under an upper limit of 55 000 lx asks for no other light.
TEST(PassFactor, NothingIsSaidOfWhatIsUndecided) {
  rules::Finding finding = sample_finding(rules::Metric::average, 500, estimate(498, 8));
  ASSERT_EQ(finding.verdict, rules::Verdict::undecided);
  EXPECT_FALSE(pass_factor(finding));
  EXPECT_EQ(pass_factor_words({}, finding), "");
  PlanePart plane;
  plane.average = finding.measured;
  EXPECT_FALSE(group_pass_factor(finding, plane, {"row 2", estimate(160, 4), 120}));
}

TEST(PassFactor, StrictLimitsAreNotMetWhereTheyAreReached) {
  rules::Finding finding = sample_finding(rules::Metric::average, 500, estimate(400, 8));
  finding.requirement.comparison = rules::Comparison::more_than;
  EXPECT_FALSE(pass_factor(finding));
  PlanePart plane;
  plane.average = finding.measured;
  EXPECT_FALSE(group_pass_factor(finding, plane, {"row 2", estimate(160, 4), 120}));
  finding.requirement.comparison = rules::Comparison::less_than;
  EXPECT_FALSE(pass_factor(finding));
}

TEST(PassFactor, RatingsDoNotGrowWithTheLight) {
  for (const auto derived : {calc::DerivedQuantity::ugr, calc::DerivedQuantity::modelling}) {
    rules::Finding finding = sample_finding(rules::Metric::average, 500, estimate(400, 8));
    finding.requirement.derived = derived;
    EXPECT_FALSE(pass_factor(finding));
    PlanePart plane;
    plane.average = finding.measured;
    EXPECT_FALSE(group_pass_factor(finding, plane, {"row 2", estimate(160, 4), 120}));
  }
}

TEST(PassFactor, OnlyWhereLightIsWhatCounts) {
  EXPECT_FALSE(pass_factor(sample_finding(rules::Metric::average, 500, estimate(600, 1))));
  EXPECT_FALSE(
      pass_factor(sample_finding(rules::Metric::uniformity_min_avg, 0.6, estimate(0.4, 0.01))));
  EXPECT_FALSE(pass_factor(sample_finding(rules::Metric::minimum, 5, estimate(0.1, 0.1))));
  rules::Finding own = sample_finding(rules::Metric::average, 500, estimate(400, 8));
  own.requirement.policy.tolerance = 0.05;
  EXPECT_FALSE(pass_factor(own));
  own.requirement.policy = {};
  own.verdict = rules::Verdict::not_judged;
  EXPECT_EQ(pass_factor_words({}, own), "");
}

TEST(PassFactor, OfOneGroupMakesUpForWhatIsMissing) {
  PlanePart plane;
  plane.average = estimate(400, 8);
  const GroupShare row{"row 2", estimate(160, 4), 120}, dark{"off", estimate(0, 0), 0};
  rules::Finding finding = sample_finding(rules::Metric::average, 500, plane.average);
  const auto factor = group_pass_factor(finding, plane, row);
  ASSERT_TRUE(factor);
  EXPECT_DOUBLE_EQ(plane.average.low + (*factor - 1) * row.average_lx.low, 500);
  EXPECT_EQ(factor_text({}, *factor), "×1.70");
  EXPECT_FALSE(group_pass_factor(finding, plane, dark));
  finding.requirement.scene = "night";
  EXPECT_FALSE(group_pass_factor(finding, plane, row));
  finding.requirement.scene = "";
  finding.requirement.metric = rules::Metric::minimum;
  EXPECT_FALSE(group_pass_factor(finding, plane, row));
}

}  // namespace
}  // namespace report::pass_factor_test
