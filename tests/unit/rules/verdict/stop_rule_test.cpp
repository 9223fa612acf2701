#include "rules/verdict/stop_rule.h"

#include "rules/measure/error_spending.h"
#include "rules/verdict/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rules::stop_rule_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

calc::SensorGrid grid_of(std::size_t points) {
  calc::SensorGrid grid;
  for (std::size_t i = 0; i < points; ++i) {
    grid.position_m.emplace_back(static_cast<double>(i), 0.0, 0.0);
  }
  return grid;
}

// Point 0 always has 100 lx; point 1 has 200 lx -+ spread in four replicates.
calc::PlaneField field_with_spread(double spread_lx) {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 4;
  field.channels = {{"night", 1.0}};
  for (const double sign : {-1.0, 1.0, 1.0, -1.0}) {
    field.indirect_lx.push_back(100);
    field.indirect_lx.push_back(200 + sign * spread_lx);
  }
  return field;
}

Requirement at_least(Metric metric, double limit) {
  Requirement requirement;
  requirement.metric = metric;
  requirement.limit = limit;
  return requirement;
}

Requirement judged(Metric metric) { return at_least(metric, 0.0); }

LookJudgement answer(const StopRule& rule, const std::vector<Requirement>& requirements,
                     const calc::PlaneField& field,
                     const std::vector<calc::LightScene>& scenes = {}) {
  return judge_look(rule, requirements, grid_of(field.points), field, scenes);
}

LookJudgement verdict_answer(const std::vector<Requirement>& requirements,
                             const calc::PlaneField& field) {
  return answer({Goal::verdict, 0.02, 0.95}, requirements, field);
}

bool is_accurate_to(double tolerance, const std::vector<Requirement>& requirements,
                    const calc::PlaneField& field,
                    const std::vector<calc::LightScene>& scenes = {}) {
  const auto finished =
      answer({Goal::accuracy, tolerance, 0.95}, requirements, field, scenes).finished;
  EXPECT_TRUE(!finished || finished == calc::StopReason::accurate);
  return finished.has_value();
}

TEST(ErrorSpending, SharesTheRiskOverTheLooks) {
  EXPECT_DOUBLE_EQ(look_confidence(0.95, 0, 1), 0.95);
  EXPECT_DOUBLE_EQ(look_confidence(0.95, 0, 6), 0.9875);
  EXPECT_DOUBLE_EQ(look_confidence(0.95, 5, 6), 0.9925);
  EXPECT_DOUBLE_EQ(look_confidence(0.9, 1, 2), 0.95);
  for (int planned = 1; planned < 31; ++planned) {
    double sum = 0.0;
    for (int look = 0; look < planned; ++look) {
      sum += risk_share(look, planned);
      // A point that was left out must not get a narrower interval later.
      if (look == 0) continue;
      EXPECT_LE(risk_share(look, planned), risk_share(look - 1, planned) + 1e-15);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12) << planned;
  }
}

TEST(ErrorSpending, TheLevelIsThatOfTheLastLookTaken) {
  calc::PlaneField field = field_with_spread(10);
  field.looks_planned = 6;
  EXPECT_DOUBLE_EQ(look_confidence(0.95, field), 0.9875);
  field.counters.active_points = {2};
  EXPECT_DOUBLE_EQ(look_confidence(0.95, field), 0.9875);
  field.counters.active_points = {2, 1, 1};
  EXPECT_DOUBLE_EQ(look_confidence(0.95, field), 0.9925);
}

// Average: 150 -+ 9.187 lx, wide, but on one side of 140.8; see AccuracyGoal.
TEST(VerdictGoal, IsReachedWithEveryVerdict) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_EQ(verdict_answer({at_least(Metric::average, 140.8)}, field).finished,
            calc::StopReason::decided);
  EXPECT_EQ(verdict_answer({at_least(Metric::average, 159.2)}, field).finished,
            calc::StopReason::decided);  // a failure is a verdict
  EXPECT_FALSE(verdict_answer({at_least(Metric::average, 140.9)}, field).finished);
  EXPECT_FALSE(
      verdict_answer({at_least(Metric::minimum, 50), at_least(Metric::average, 150)}, field)
          .finished);
}

TEST(VerdictGoal, DoesNotAskForTheTolerance) {
  EXPECT_TRUE(verdict_answer({at_least(Metric::average, 100)}, field_with_spread(10)).finished);
  EXPECT_FALSE(is_accurate_to(0.02, {at_least(Metric::average, 100)}, field_with_spread(10)));
}

// With two looks each has half the risk: t of three degrees of freedom at 1 - 0.05 / 4 is 4.1765,
// 150 -+ 12.06 lx.
TEST(VerdictGoal, SpendsTheRiskOverThePlannedLooks) {
  calc::PlaneField field = field_with_spread(10);
  field.looks_planned = 2;
  EXPECT_FALSE(verdict_answer({at_least(Metric::average, 138.0)}, field).finished);
  EXPECT_TRUE(verdict_answer({at_least(Metric::average, 137.9)}, field).finished);
}

// The rule must never stop at an interval that is then judged, and printed, at another level.
TEST(VerdictGoal, StopsAtTheIntervalsThatAreJudgedAfterwards) {
  calc::PlaneField field = field_with_spread(10);
  for (const int planned : {1, 2, 9}) {
    field.looks_planned = planned;
    for (double limit = 120.0; limit < 180.0; limit += 0.5) {
      const std::vector<Requirement> requirements{at_least(Metric::average, limit)};
      const bool is_open =
          judge_plane(requirements, grid_of(2), field, {}, 0.95)[0].verdict == Verdict::undecided;
      EXPECT_EQ(verdict_answer(requirements, field).finished.has_value(), !is_open) << limit;
    }
  }
}

TEST(VerdictGoal, WithoutRequirementsIsAccuracy) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_EQ(answer({Goal::verdict, 0.0613, 0.95}, {}, field).finished, calc::StopReason::accurate);
  EXPECT_FALSE(answer({Goal::verdict, 0.0612, 0.95}, {}, field).finished);
}

TEST(VerdictGoal, DoesNotWaitForWhatDoesNotExist) {
  Requirement outside = at_least(Metric::value_at_point, 100);
  outside.arguments = PointOfValue{glm::dvec3(50, 50, 50), {}};
  EXPECT_EQ(verdict_answer({outside}, field_with_spread(10)).finished, calc::StopReason::decided);
}

// Uo of a plane that no sample has reached is not defined yet, but may be after the next look.
TEST(VerdictGoal, WaitsForTheFirstSample) {
  calc::PlaneField field = field_with_spread(0);
  for (double& value : field.indirect_lx) value = 0.0;
  EXPECT_TRUE(verdict_answer({at_least(Metric::uniformity_min_avg, 0.5)}, field).finished);
  field.unseen = {1, 1};
  EXPECT_FALSE(verdict_answer({at_least(Metric::uniformity_min_avg, 0.5)}, field).finished);
}

// Four points with noise of their own: 100, 150, 250 and 300 lx -+ 1.84.
calc::PlaneField four_points() {
  calc::PlaneField field;
  field.points = 4;
  field.replicates = 4;
  field.channels = {{"", 1.0}};
  for (const double s : {-1.0, 1.0, -1.0, 1.0}) {
    for (const double value : {100 + s, 150 - s, 250 + s, 300 - s}) {
      field.indirect_lx.push_back(value);
    }
  }
  return field;
}

TEST(ActivePoints, AreThoseOfTheOpenRequirementsOnly) {
  const Requirement minimum = at_least(Metric::minimum, 100),
                    open_maximum = judged(Metric::maximum);
  EXPECT_THAT(verdict_answer({minimum}, four_points()).active, ElementsAre(1, 0, 0, 0));
  // The average is decided: it needs nothing more.
  EXPECT_THAT(verdict_answer({minimum, at_least(Metric::average, 150)}, four_points()).active,
              ElementsAre(1, 0, 0, 0));
  Requirement maximum = at_least(Metric::maximum, 300);
  EXPECT_THAT(verdict_answer({minimum, maximum}, four_points()).active, ElementsAre(1, 0, 0, 1));
}

// What a report says of a look is what the plane is judged by, whatever the goal.
TEST(JudgeLook, FindsWhatThePlaneIsJudgedBy) {
  calc::PlaneField field = four_points();
  field.largest_share = {0.01F, 0.6F, 0.01F, 0.01F};
  const std::vector<Requirement> requirements{at_least(Metric::minimum, 80),
                                              at_least(Metric::average, 100)};
  const std::vector<Finding> judged = judge_plane(requirements, grid_of(4), field, {}, 0.95);
  for (const Goal goal : {Goal::verdict, Goal::accuracy}) {
    const LookJudgement look = answer({goal, 0.02, 0.95}, requirements, field);
    ASSERT_EQ(look.findings.size(), judged.size());
    for (std::size_t i = 0; i < judged.size(); ++i) {
      EXPECT_EQ(look.findings[i].verdict, judged[i].verdict);
      EXPECT_EQ(look.findings[i].measured.low, judged[i].measured.low);
      EXPECT_TRUE(look.findings[i].reason == judged[i].reason);
    }
  }
  EXPECT_THAT(answer({Goal::verdict, 0.02, 0.95}, {}, field).findings, IsEmpty());
}

TEST(ActivePoints, AreAllForAnOpenAverage) {
  calc::PlaneField field = four_points();
  for (std::size_t r = 0; r < 4; ++r) field.indirect_lx[4 * r + 3] += r < 2 ? 5.0 : -5.0;
  const LookJudgement open =
      verdict_answer({at_least(Metric::minimum, 100), at_least(Metric::average, 200)}, field);
  EXPECT_FALSE(open.finished);
  EXPECT_THAT(open.active, IsEmpty());
}

TEST(ActivePoints, HoldWhatMayBeTheMinimumIfAccuracyIsTheGoal) {
  const StopRule rule{Goal::accuracy, 0.001, 0.95};
  EXPECT_THAT(answer(rule, {judged(Metric::minimum)}, four_points()).active,
              ElementsAre(1, 0, 0, 0));
}

TEST(ActivePoints, KeepAnUnseenPointThatMatters) {
  calc::PlaneField field = four_points();
  for (std::size_t r = 0; r < 4; ++r) field.indirect_lx[4 * r + 1] = 0.0;
  field.unseen = {0, 1, 0, 0};
  const LookJudgement open = verdict_answer({at_least(Metric::minimum, 50)}, field);
  EXPECT_FALSE(open.finished);
  EXPECT_THAT(open.active, ElementsAre(0, 1, 0, 0));
}

// Point 1 would be 150 lx, and pass with its interval, but 60 % of that is one sample.
TEST(SingleSamples, LeaveTheVerdictOpenAndThePointActive) {
  calc::PlaneField field = four_points();
  field.largest_share = {0.01F, 0.6F, 0.01F, 0.01F};
  const std::vector<Requirement> requirements{at_least(Metric::minimum, 80)};
  const Finding finding = judge_plane(requirements, grid_of(4), field, {}, 0.95)[0];
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(finding.reason,
            "the result rests on single samples at 1 of 4 points; their intervals are not "
            "reliable; about 8 times as many light paths would decide it (--max-paths)");
  const LookJudgement open = verdict_answer(requirements, field);
  EXPECT_FALSE(open.finished);
  EXPECT_THAT(open.active, ElementsAre(0, 1, 0, 0));
  EXPECT_FALSE(is_accurate_to(0.5, {judged(Metric::maximum)}, [&field] {
    calc::PlaneField brightest = field;
    brightest.largest_share = {0.0F, 0.0F, 0.0F, 0.6F};
    return brightest;
  }()));
}

TEST(SingleSamples, DoNotMatterWhereTheVerdictDoesNotHangOnThem) {
  calc::PlaneField field = four_points();
  field.largest_share = {0.01F, 0.01F, 0.6F, 0.01F};  // 40 % of 250 lx is still more than 80 lx
  EXPECT_EQ(verdict_answer({at_least(Metric::minimum, 80)}, field).finished,
            calc::StopReason::decided);
}

// Average: half-width = 3.1824 * (10 / 2) * sqrt(4 / 3) / 2 = 9.187 lx of 150 lx, 6.12 %.
TEST(AccuracyGoal, ComparesHalfWidthWithTheToleranceOfTheValue) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_TRUE(is_accurate_to(0.0613, {judged(Metric::average)}, field));
  EXPECT_FALSE(is_accurate_to(0.0612, {judged(Metric::average)}, field));
}

TEST(AccuracyGoal, DoesNotStopAtAVerdict) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_FALSE(is_accurate_to(0.0612, {at_least(Metric::average, 1)}, field));
}

TEST(AccuracyGoal, LooksAtJudgedQuantitiesOnly) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_TRUE(is_accurate_to(1e-9, {judged(Metric::minimum)}, field));
  EXPECT_FALSE(is_accurate_to(0.05, {judged(Metric::minimum), judged(Metric::maximum)}, field));
}

TEST(AccuracyGoal, WithoutRequirementsIsThatOfAverageAndMinimum) {
  const calc::PlaneField field = field_with_spread(10);
  EXPECT_TRUE(is_accurate_to(0.0613, {}, field));  // the maximum would need 9.2 %
  EXPECT_FALSE(is_accurate_to(0.0612, {}, field));
  calc::PlaneField swapped = field;  // 100 lx -+ 10 at the minimum, too: 18 %
  for (std::size_t r = 0; r < 4; ++r)
    swapped.indirect_lx[2 * r] = field.indirect_lx[2 * r + 1] - 100;
  EXPECT_FALSE(is_accurate_to(0.15, {}, swapped));
  EXPECT_TRUE(is_accurate_to(0.15, {judged(Metric::average)}, swapped));
}

TEST(AccuracyGoal, UsesTheSceneOfTheRequirement) {
  Requirement requirement = judged(Metric::average);
  requirement.scene = "off";
  const std::vector<calc::LightScene> scenes{{"off", {{"night", 0.0}}, {}}};
  EXPECT_TRUE(is_accurate_to(1e-9, {requirement}, field_with_spread(10), scenes));
}

TEST(AccuracyGoal, OfExactDarknessIsReached) {
  calc::PlaneField dark = field_with_spread(0);
  for (double& value : dark.indirect_lx) value = 0.0;
  EXPECT_TRUE(is_accurate_to(0.02, {}, dark));
  EXPECT_TRUE(is_accurate_to(0.02, {judged(Metric::uniformity_min_avg)}, dark));
}

TEST(AccuracyGoal, OfAPlaceOutsideTheGridIsReached) {
  Requirement requirement = judged(Metric::value_at_point);
  requirement.arguments = PointOfValue{glm::dvec3(50, 50, 50), {}};
  EXPECT_TRUE(is_accurate_to(0.02, {requirement}, field_with_spread(100)));
}

}  // namespace
}  // namespace rules::stop_rule_test
