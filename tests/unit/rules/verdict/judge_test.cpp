#include "rules/verdict/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

namespace rules::judge_test {
namespace {

// Three points in a row, cells of 1 m x 0.5 m.
calc::SensorGrid row_of_points() {
  calc::SensorGrid grid;
  grid.columns = 3;
  grid.rows = 1;
  grid.spacing_u_m = 1.0;
  grid.spacing_v_m = 0.5;
  grid.position_m = {{0.5, 0.25, 0.75}, {1.5, 0.25, 0.75}, {2.5, 0.25, 0.75}};
  grid.normal.assign(3, {0, 0, 1});
  return grid;
}

calc::PlaneField exact_field(std::vector<double> values_lx) {
  calc::PlaneField field;
  field.plane_id = "desk";
  field.points = values_lx.size();
  field.replicates = 16;
  field.channels = {{"window", 0.8}};
  field.direct_exact_lx = std::move(values_lx);
  return field;
}

// Two replicates per value pair: average - spread, average + spread at every point.
calc::PlaneField sampled_field(double average_lx, double spread_lx) {
  calc::PlaneField field = exact_field({0, 0, 0});
  field.replicates = 4;
  field.channels = {{"", 1.0}};
  for (const double sign : {-1.0, 1.0, -1.0, 1.0}) {
    field.indirect_lx.insert(field.indirect_lx.end(), 3, average_lx + sign * spread_lx);
  }
  return field;
}

const std::string kTooClose =
    "; the value is too close to the limit; no number of light paths can decide it";

Requirement at_least(Metric metric, double limit) {
  Requirement requirement;
  requirement.plane_id = "desk";
  requirement.metric = metric;
  requirement.limit = limit;
  return requirement;
}

Finding judge(const Requirement& requirement, const calc::PlaneField& field,
              const std::vector<calc::LightScene>& scenes = {}) {
  return judge_plane({requirement}, row_of_points(), field, scenes, 0.95).at(0);
}

TEST(Judge, PassesWithValueMarginAndPlace) {
  const Finding finding = judge(at_least(Metric::minimum, 200), exact_field({500, 300, 400}));
  EXPECT_EQ(finding.verdict, Verdict::pass);  // 300 lx times the maintenance factor 0.8
  EXPECT_DOUBLE_EQ(finding.measured.value, 240);
  EXPECT_DOUBLE_EQ(finding.margin, 0.2);
  EXPECT_FALSE(finding.is_close);
  ASSERT_TRUE(finding.place_m.has_value());
  EXPECT_EQ(*finding.place_m, glm::dvec3(1.5, 0.25, 0.75));
  EXPECT_EQ(finding.reason, "");
  EXPECT_EQ(finding.requirement.metric, Metric::minimum);
}

// 0.25 % upwards where none is allowed is no margin of "+0.0 %".
TEST(Judge, WhatFailsHasNoMarginThatReadsAsGood) {
  Requirement none = at_least(Metric::maximum, 0.0);
  none.comparison = Comparison::at_most;
  const Finding of_nothing = judge(none, exact_field({500, 300, 400}));
  EXPECT_EQ(of_nothing.verdict, Verdict::fail);
  EXPECT_TRUE(std::isnan(of_nothing.margin));
  // 240 lx is not more than 240 lx.
  Requirement more = at_least(Metric::minimum, 240.0);
  more.comparison = Comparison::more_than;
  const Finding exactly = judge(more, exact_field({500, 300, 400}));
  EXPECT_EQ(exactly.verdict, Verdict::fail);
  EXPECT_TRUE(std::isnan(exactly.margin));
  // 239.6 lx, rounded down.
  Requirement rounded = at_least(Metric::minimum, 239.5);
  rounded.policy.compares_rounded = true;
  rounded.policy.rounding = Rounding::down;
  const Finding by_rounding = judge(rounded, exact_field({500, 299.5, 400}));
  EXPECT_EQ(by_rounding.verdict, Verdict::fail);
  EXPECT_TRUE(std::isnan(by_rounding.margin));
}

// A refused plane has no values: its zeros must never be judged.
TEST(Judge, ARefusedPlaneIsNotJudged) {
  calc::PlaneField field = exact_field({0, 0, 0});
  field.problem = calc::Message::words("no steady state");
  Requirement at_most = at_least(Metric::maximum, 1000);
  at_most.comparison = Comparison::at_most;
  for (const Requirement& requirement : {at_most, at_least(Metric::average, 100)}) {
    const Finding finding = judge(requirement, field);
    EXPECT_EQ(finding.verdict, Verdict::not_judged);
    EXPECT_EQ(finding.reason, "no steady state");
  }
}

// Sampled light may reach point 1 but no sample has: its 0 lx +- 0 proves nothing.
TEST(Judge, PointsThatNoSampleReachedLeaveTheVerdictOpen) {
  calc::PlaneField field = sampled_field(500, 1);
  for (std::size_t r = 0; r < 4; ++r) field.indirect_lx[3 * r + 1] = 0.0;
  field.unseen = {0, 1, 0};
  const Finding minimum = judge(at_least(Metric::minimum, 100), field);
  EXPECT_EQ(minimum.verdict, Verdict::undecided);
  EXPECT_EQ(minimum.reason,
            "no sampled light reached 1 of 3 points; their illuminance is small, but not known");
  EXPECT_GT(minimum.measured.high, 400.0);  // the other two: it may be as much
  EXPECT_EQ(judge(at_least(Metric::average, 100), field).verdict, Verdict::pass);
  field.unseen = {0, 0, 0};  // nothing can reach it: 0 lx is the truth
  EXPECT_EQ(judge(at_least(Metric::minimum, 100), field).verdict, Verdict::fail);
}

// Clamped light is too little: more of it can only make these surer, and turn all others.
TEST(Judge, WhatIsCutOffIsInNoInterval) {
  calc::PlaneField field = sampled_field(500, 1);
  field.is_cut_off = true;
  const auto verdict = [&](Requirement requirement, Comparison comparison) {
    requirement.comparison = comparison;
    const Finding finding = judge(requirement, field);
    EXPECT_EQ(finding.is_doubtful, finding.verdict == Verdict::undecided);
    return finding.verdict;
  };
  constexpr Comparison kLeast = Comparison::at_least, kMost = Comparison::at_most;
  EXPECT_EQ(verdict(at_least(Metric::average, 400), kLeast), Verdict::pass);
  EXPECT_EQ(verdict(at_least(Metric::average, 600), kLeast), Verdict::undecided);
  EXPECT_EQ(verdict(at_least(Metric::average, 400), kMost), Verdict::fail);
  EXPECT_EQ(verdict(at_least(Metric::average, 600), kMost), Verdict::undecided);
  EXPECT_EQ(verdict(at_least(Metric::uniformity_min_avg, 0.5), kLeast), Verdict::undecided);
  Requirement direct = at_least(Metric::average, 600);
  direct.direct_only = true;
  EXPECT_EQ(verdict(direct, kLeast), Verdict::fail);
}

// Light that may be more or less: nothing passes.
TEST(Judge, NothingPassesOnLightThatIsUnsure) {
  const auto judge_unsure = [](Requirement requirement, Comparison comparison) {
    requirement.comparison = comparison;
    requirement.unsure_light = calc::Message::words("a room stands between");
    const Finding finding = judge(requirement, exact_field({625, 625, 625}));  // 500 lx
    EXPECT_EQ(finding.is_doubtful, finding.verdict == Verdict::undecided);
    EXPECT_EQ(finding.reason, requirement.unsure_light) << "what fails says what is to mend, too";
    return finding.verdict;
  };
  constexpr Comparison kLeast = Comparison::at_least, kMost = Comparison::at_most;
  EXPECT_EQ(judge_unsure(at_least(Metric::average, 400), kLeast), Verdict::undecided);
  EXPECT_EQ(judge_unsure(at_least(Metric::average, 600), kLeast), Verdict::fail);
  EXPECT_EQ(judge_unsure(at_least(Metric::maximum, 600), kMost), Verdict::undecided);
}

// A photometry that ends in the light: more of it would leave these passes, and turn all others.
// What fails by the light that is known fails; where more could turn it, it says so.
TEST(Judge, NothingPassesThatMissingLightCouldFail) {
  const auto judge_missing = [](Requirement requirement, Comparison comparison) {
    requirement.comparison = comparison;
    requirement.missing_light = calc::Message::words("the file ends at 60 degrees");
    const Finding finding = judge(requirement, exact_field({625, 625, 625}));  // 500 lx
    EXPECT_EQ(finding.is_doubtful, finding.verdict == Verdict::undecided);
    const bool is_least = is_lower_limit(comparison) && metric_row(requirement.metric).is_linear;
    const bool is_sure = finding.verdict == (is_least ? Verdict::pass : Verdict::fail);
    EXPECT_EQ(finding.reason, is_sure ? calc::Message() : requirement.missing_light);
    return finding.verdict;
  };
  constexpr Comparison kLeast = Comparison::at_least, kMost = Comparison::at_most;
  EXPECT_EQ(judge_missing(at_least(Metric::average, 400), kLeast), Verdict::pass);
  EXPECT_EQ(judge_missing(at_least(Metric::average, 600), kLeast), Verdict::fail);
  EXPECT_EQ(judge_missing(at_least(Metric::maximum, 600), kMost), Verdict::undecided);
  EXPECT_EQ(judge_missing(at_least(Metric::maximum, 400), kMost), Verdict::fail);
  EXPECT_EQ(judge_missing(at_least(Metric::uniformity_min_avg, 0.5), kLeast), Verdict::undecided);
  for (const Metric metric : {Metric::intensity, Metric::upward_share}) {
    Requirement of_space = at_least(metric, 10);
    of_space.of_space = {5, 5, 5};
    EXPECT_EQ(judge_missing(of_space, kMost), Verdict::undecided);
  }
}

TEST(Judge, FailsWithANegativeMargin) {
  const Finding finding = judge(at_least(Metric::average, 400), exact_field({500, 300, 400}));
  EXPECT_EQ(finding.verdict, Verdict::fail);
  EXPECT_DOUBLE_EQ(finding.margin, -0.2);
  EXPECT_FALSE(finding.place_m.has_value());
}

TEST(Judge, FailsCloselyWhereAPrintedNumberWouldPass) {
  const Finding finding = judge(at_least(Metric::average, 500), exact_field({624.5, 624.5, 624.5}));
  EXPECT_DOUBLE_EQ(finding.measured.value, 499.6);
  EXPECT_EQ(finding.verdict, Verdict::fail);
  EXPECT_TRUE(finding.is_close);
}

TEST(Judge, FailsAUniformityThatPrintsAsItsLimit) {
  const Finding finding =
      judge(at_least(Metric::uniformity_min_avg, 0.60), exact_field({59.5, 100, 140.5}));
  EXPECT_DOUBLE_EQ(finding.measured.value, 0.595);
  EXPECT_EQ(finding.verdict, Verdict::fail);
  EXPECT_TRUE(finding.is_close);
}

TEST(Judge, PassesExactlyAtTheLimit) {
  EXPECT_EQ(judge(at_least(Metric::average, 400), exact_field({500, 500, 500})).verdict,
            Verdict::pass);
}

TEST(Judge, UsesTheStateOfTheRequirement) {
  Requirement requirement = at_least(Metric::average, 450);
  EXPECT_EQ(judge(requirement, exact_field({500, 500, 500})).verdict, Verdict::fail);
  requirement.state = LightState::initial;
  EXPECT_EQ(judge(requirement, exact_field({500, 500, 500})).verdict, Verdict::pass);
}

TEST(Judge, UsesTheSceneOfTheRequirement) {
  Requirement requirement = at_least(Metric::average, 100);
  requirement.scene = "day";
  const std::vector<calc::LightScene> scenes{{"night", {}, {}}, {"day", {{"window", 0.5}}, {}}};
  EXPECT_DOUBLE_EQ(judge(requirement, exact_field({500, 500, 500}), scenes).measured.value, 200);
}

TEST(Judge, SaysThatASceneIsMissing) {
  Requirement requirement = at_least(Metric::average, 100);
  requirement.scene = "day";
  const Finding finding = judge(requirement, exact_field({500, 500, 500}));
  EXPECT_EQ(finding.verdict, Verdict::not_judged);
  EXPECT_EQ(finding.reason, "there is no scene 'day'");
}

TEST(Judge, IsUndecidedWithinTheInterval) {
  // standard error 5 * sqrt(4 / 3) / 2, t 3.182: 500 -+ 9.19
  const Finding finding = judge(at_least(Metric::average, 505), sampled_field(500, 5));
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_EQ(
      finding.reason,
      "the interval 491 to 509 lx contains the limit 505 lx; about 4 times as many light paths "
      "would decide it (--max-paths)");
}

TEST(Judge, ShowsEnoughDigitsToBelieveTheReason) {
  // 500 -+ 0.0184 and 500 -+ 0.184
  EXPECT_EQ(judge(at_least(Metric::average, 500), sampled_field(500, 0.01)).reason,
            "the interval 499.98 to 500.02 lx contains the limit 500 lx" + kTooClose);
  EXPECT_EQ(judge(at_least(Metric::average, 499.9), sampled_field(500, 0.1)).reason,
            "the interval 499.8 to 500.2 lx contains the limit 499.9 lx; about 4 times as many "
            "light paths would decide it (--max-paths)");
  EXPECT_EQ(judge(at_least(Metric::average, 2), sampled_field(2, 0.1)).reason,
            "the interval 1.82 to 2.18 lx contains the limit 2 lx" + kTooClose);
}

// 500 -+ 9.19 lx.
TEST(Judge, SaysHowMuchMoreWorkWouldDecide) {
  const auto reason_at = [](double limit) {
    return judge(at_least(Metric::average, limit), sampled_field(500, 5)).reason.english();
  };
  EXPECT_THAT(reason_at(508), testing::HasSubstr("about 2 times"));
  EXPECT_THAT(reason_at(502.5), testing::HasSubstr("about 16 times"));  // 3.7^2
  EXPECT_THAT(reason_at(497.5), testing::HasSubstr("about 16 times"));
  EXPECT_THAT(reason_at(500.01), testing::HasSubstr("too close to the limit"));
  EXPECT_EQ(reason_at(400), "");
}

TEST(Judge, SaysWhenASingleSampleWouldBeSmallEnough) {
  calc::PlaneField field = sampled_field(500, 1);
  field.largest_share = {0.75F, 0.01F, 0.01F};
  const Finding finding = judge(at_least(Metric::minimum, 200), field);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_THAT(finding.reason.english(),
              testing::HasSubstr("about 8 times as many light paths would decide it"));
}

// An average of 500 -+ 1.84 lx to which one sample may add 20 lx at a point, and so 6.7 lx.
TEST(Judge, LeavesOpenWhatASampleThatWasNotDrawnMayChange) {
  Requirement at_most = at_least(Metric::average, 505);
  at_most.comparison = Comparison::at_most;
  calc::PlaneField field = sampled_field(500, 1);
  EXPECT_EQ(judge(at_most, field).verdict, Verdict::pass);
  field.largest_sample_lx = {20.0, 0.0, 0.0};
  EXPECT_EQ(judge(at_most, field).verdict, Verdict::undecided);
  EXPECT_EQ(judge(at_least(Metric::average, 495), field).verdict, Verdict::pass);
}

TEST(Judge, ShowsRatiosWithoutUnit) {
  calc::PlaneField field = sampled_field(100, 0);
  field.indirect_lx = {55, 90, 155, 65, 110, 125, 60, 100, 140, 60, 100, 140};
  const Finding finding = judge(at_least(Metric::uniformity_min_avg, 0.6), field);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  // 0.6 - 3.182 * 0.0204; above, three points share the level: 0.6 + 4.857 * 0.0204
  EXPECT_EQ(finding.reason, "the interval 0.54 to 0.70 contains the limit 0.6" + kTooClose);
}

TEST(Judge, DoesNotJudgeAnUndefinedUniformity) {
  const Finding uo = judge(at_least(Metric::uniformity_min_avg, 0.6), exact_field({0, 0, 0}));
  EXPECT_EQ(uo.verdict, Verdict::not_judged);
  EXPECT_EQ(uo.reason, "the average is 0 lx, so the uniformity is undefined");
  const Finding ud = judge(at_least(Metric::uniformity_min_max, 0.1), exact_field({0, 0, 0}));
  EXPECT_EQ(ud.reason, "the maximum is 0 lx, so the uniformity is undefined");
  EXPECT_EQ(ud.margin, 0.0);
}

TEST(Judge, FailsADarkPlaneWhereTheQuantityExists) {
  EXPECT_EQ(judge(at_least(Metric::average, 100), exact_field({0, 0, 0})).verdict, Verdict::fail);
}

Requirement value_at(const glm::dvec3& point_m) {
  Requirement requirement = at_least(Metric::value_at_point, 200);
  requirement.arguments = PointOfValue{point_m, {}};
  return requirement;
}

TEST(Judge, TakesTheCalculationPointNextToAPlace) {
  const Finding finding = judge(value_at({1.9, 0.4, 0.8}), exact_field({500, 300, 400}));
  EXPECT_DOUBLE_EQ(finding.measured.value, 240);
  EXPECT_EQ(*finding.place_m, glm::dvec3(1.5, 0.25, 0.75));
}

TEST(Judge, TakesAPlaceOnTheEdgeOfACell) {
  EXPECT_EQ(judge(value_at({3.0, 0.5, 0.75}), exact_field({500, 300, 400})).verdict, Verdict::pass);
}

TEST(Judge, DoesNotJudgeAPlaceWithoutACalculationPoint) {
  const calc::PlaneField field = exact_field({500, 300, 400});
  const std::string nearest = "; the nearest is at (2.500, 0.250, 0.750) m";
  const std::string none =
      "no calculation point is within half a cell (0.500 x 0.250 m) along the plane and 0.05 m "
      "across it of ";
  const Finding along = judge(value_at({3.1, 0.25, 0.75}), field);
  EXPECT_EQ(along.verdict, Verdict::not_judged);
  EXPECT_EQ(along.reason, none + "(3.100, 0.250, 0.750) m" + nearest);
  EXPECT_EQ(judge(value_at({2.5, 0.6, 0.75}), field).verdict, Verdict::not_judged);
  EXPECT_EQ(judge(value_at({2.5, 0.25, 0.0}), field).verdict, Verdict::not_judged);
}

TEST(Judge, WantsThePointItselfOfAPointList) {
  calc::SensorGrid list = row_of_points();
  list.columns = list.rows = 0;
  list.spacing_u_m = list.spacing_v_m = 0.0;
  const calc::PlaneField field = exact_field({500, 300, 400});
  EXPECT_EQ(judge_plane({value_at({1.5005, 0.25, 0.75})}, list, field, {}, 0.95)[0].verdict,
            Verdict::pass);
  const Finding off = judge_plane({value_at({1.6, 0.25, 0.75})}, list, field, {}, 0.95)[0];
  EXPECT_EQ(off.verdict, Verdict::not_judged);
  EXPECT_EQ(off.reason,
            "no calculation point is within 0.001 m of (1.600, 0.250, 0.750) m; the nearest is "
            "at (1.500, 0.250, 0.750) m");
}

TEST(Judge, WantsToKnowWhichOfTwoPointsAtOnePlaceIsMeant) {
  calc::SensorGrid list = row_of_points();
  list.columns = list.rows = 0;
  list.position_m[2] = list.position_m[0];
  list.normal[2] = {0, 1, 0};
  const calc::PlaneField field = exact_field({500, 300, 400});
  Requirement value = value_at(list.position_m[0]);
  value.limit = 350.0;
  auto& facing = std::get<PointOfValue>(value.arguments).facing;
  const auto judged = [&] { return judge_plane({value}, list, field, {}, 0.95)[0]; };
  EXPECT_EQ(judged().verdict, Verdict::not_judged);
  EXPECT_EQ(judged().reason,
            "2 calculation points at (0.500, 0.250, 0.750) m look in different directions: (0 0 "
            "1), (0 1 0); choose one with 'facing'");
  facing = glm::dvec3(0, 0, 1);
  EXPECT_EQ(judged().verdict, Verdict::pass);
  facing = glm::dvec3(0, 1, 0);
  EXPECT_EQ(judged().verdict, Verdict::fail) << "0.8 x 400 lx";
  facing = glm::dvec3(1, 0, 0);
  EXPECT_EQ(judged().verdict, Verdict::not_judged);
  EXPECT_EQ(
      judged().reason,
      "no calculation point at (0.500, 0.250, 0.750) m looks towards (1 0 0); directions there: "
      "(0 0 1), (0 1 0)");
  facing.reset();
  list.normal[2] = {0, 0, 1};
  EXPECT_EQ(judged().verdict, Verdict::pass) << "twice the same point";
  list.normal[2] = {0, 1, 0};
  list.kernel = calc::ReceiverKernel::scalar;
  EXPECT_EQ(judged().verdict, Verdict::pass) << "a sphere looks nowhere";
}

TEST(Judge, APlaneLooksOneWayOnly) {
  Requirement value = value_at({0.5, 0.25, 0.75});
  auto& facing = std::get<PointOfValue>(value.arguments).facing;
  facing = glm::dvec3(0, 0, 1);
  EXPECT_EQ(judge(value, exact_field({500, 300, 400})).verdict, Verdict::pass);
  facing = glm::dvec3(0, 0, -1);
  EXPECT_EQ(judge(value, exact_field({500, 300, 400})).verdict, Verdict::not_judged);
}

TEST(Judge, KeepsTheOrderOfRequirements) {
  const std::vector<Finding> findings =
      judge_plane({at_least(Metric::maximum, 1), at_least(Metric::minimum, 1000)}, row_of_points(),
                  exact_field({500, 300, 400}), {}, 0.95);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].verdict, Verdict::pass);
  EXPECT_EQ(findings[1].verdict, Verdict::fail);
}

TEST(NotJudgedPlane, RepeatsTheReasonForEveryRequirement) {
  const std::vector<Finding> findings =
      not_judged_plane({at_least(Metric::average, 1), at_least(Metric::minimum, 2)},
                       calc::Message::words("no point is left"));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[1].verdict, Verdict::not_judged);
  EXPECT_EQ(findings[1].reason, "no point is left");
  EXPECT_EQ(findings[1].requirement.limit, 2);
}

}  // namespace
}  // namespace rules::judge_test
