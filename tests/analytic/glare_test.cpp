// UGR: Guth's index, one source in a uniform field, a hand-computed installation, and what is known
// of sources that the formula is not stated for.

#include "calc/radiosity/direct/glare.h"

#include "calc/base/units.h"
#include "calc/glare/position_index.h"
#include "calc/scene/opening.h"
#include "rules/measure/derived_points.h"
#include "rules/measure/measure.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/stop_rule.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace glare_test {
namespace {

using namespace test_support;
using rules::Measurement;

const calc::LuminousOpening kPanel{calc::OpeningShape::rectangle, 0.6, 0.6, 0.0};
const glm::dvec3 kAhead(1, 0, 0);

calc::SensorGrid eyes(std::vector<glm::dvec3> positions_m, const glm::dvec3& look = kAhead) {
  calc::SensorGrid grid;
  grid.derived = calc::DerivedQuantity::ugr;
  grid.normal.assign(positions_m.size(), look);
  grid.position_m = std::move(positions_m);
  return grid;
}

calc::PreparedScene room_with(const calc::PhotometricWeb& web,
                              const std::vector<glm::dvec3>& luminaires_m,
                              double reflectance = 0.5) {
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {8, 6, 2.8}, reflectance);
  for (const glm::dvec3& at : luminaires_m) add_luminaire(scene, web, at);
  set_extent(scene);
  return scene;
}

calc::PlaneField solve_eyes(const calc::PreparedScene& scene, const calc::SensorGrid& grid,
                            std::uint64_t paths = 1024) {
  return solve_with_paths(scene, grid, 1, paths).fields[0];
}

rules::Requirement at_most(double limit) {
  rules::Requirement requirement;
  requirement.metric = rules::Metric::maximum;
  requirement.comparison = rules::Comparison::at_most;
  requirement.limit = limit;
  requirement.state = rules::LightState::initial;
  requirement.derived = calc::DerivedQuantity::ugr;
  return requirement;
}

Measurement measure_ugr(const calc::SensorGrid& grid, const calc::PlaneField& field,
                        rules::Metric metric = rules::Metric::maximum) {
  rules::Requirement requirement = at_most(19.0);
  requirement.metric = metric;
  return rules::measure(requirement, grid, field, {}, 0.95);
}

double mean_indirect_lx(const calc::PlaneField& field, std::size_t i) {
  double sum = 0.0;
  for (std::size_t r = 0; r < field.replicates; ++r) sum += field.indirect_lx[r * field.points + i];
  return sum / static_cast<double>(field.replicates);
}

// Values of the closed form, computed by hand.
TEST(GuthIndex, IsThatOfTheClosedForm) {
  EXPECT_NEAR(calc::guth_index({2, 0, 0}, kAhead).value(), 1.0, 1e-12);
  EXPECT_NEAR(calc::guth_index({3, 0, 3}, kAhead).value(), 7.059329, 1e-6);
  EXPECT_NEAR(calc::guth_index({3, -3, 0}, kAhead).value(), 2.049807, 1e-6);
  EXPECT_NEAR(calc::guth_index({2, 0, 1}, kAhead).value(), 2.860161, 1e-6);
  const double sine = std::sqrt(0.5) * std::tan(calc::radians_from_degrees(30.0));
  EXPECT_NEAR(calc::guth_index({1, sine, sine}, kAhead).value(), 2.383327, 1e-6);
  // The line of sight turns with the eye.
  EXPECT_NEAR(calc::guth_index({0, -2, 1}, {0, -1, 0}).value(), 2.860161, 1e-6);
}

TEST(GuthIndex, ExistsInItsFieldAboveTheLineOfSightOnly) {
  EXPECT_TRUE(calc::guth_index({1, 2.99, 0}, kAhead));
  EXPECT_FALSE(calc::guth_index({1, 3.01, 0}, kAhead));
  EXPECT_TRUE(calc::guth_index({1, 0, 1.99}, kAhead));
  EXPECT_FALSE(calc::guth_index({1, 0, 2.01}, kAhead));
  // At exactly 2 a source is out, whatever binary numbers make of 1.6 / 0.8.
  EXPECT_FALSE(calc::guth_index({1, 0, 2}, kAhead));
  EXPECT_FALSE(calc::guth_index({0.8, 0, 2.8 - 1.2}, kAhead));
  EXPECT_FALSE(calc::guth_index({0.1, 0.3, 0.2}, kAhead));
  EXPECT_TRUE(calc::guth_index({0.1, 0.3, 0.19}, kAhead));  // sideways 3 is in
  EXPECT_FALSE(calc::guth_index({1, 0, -0.1}, kAhead));
  EXPECT_FALSE(calc::guth_index({-1, 0, 0.1}, kAhead));
  EXPECT_FALSE(calc::guth_index({0, 1, 0}, kAhead));
}

// Nodes of the table of CIE 117 and what the closed form has there, computed apart from this
// program.
TEST(GuthIndex, IsNearTheTable) {
  struct Node {
    double sideways, upwards, table, closed;
  };
  for (const Node& node :
       {Node{0, 0.5, 2.86, 2.860}, Node{0, 1, 7.00, 7.059}, Node{1, 0, 2.11, 2.050},
        Node{1, 1, 7.00, 7.030}, Node{2, 0.5, 5.80, 5.459}, Node{3, 1.9, 16.00, 15.062}}) {
    const double index = calc::guth_index({1, node.sideways, node.upwards}, kAhead).value();
    EXPECT_NEAR(index, node.closed, 5e-4);
    EXPECT_NEAR(index / node.table, 1.0, 0.12);
    EXPECT_LE(node.upwards, calc::highest_on_table(node.sideways));
  }
  // T/R 0.5 and H/R 1.9: no entry; the closed form goes on.
  EXPECT_NEAR(calc::guth_index({1, 0.5, 1.9}, kAhead).value(), 17.885, 5e-4);
  EXPECT_LT(calc::highest_on_table(0.5), 1.9);
}

TEST(GuthIndex, TheTableEndsByHowFarAside) {
  EXPECT_EQ(calc::highest_on_table(0.0), 1.7);
  EXPECT_EQ(calc::highest_on_table(0.39), 1.7);
  EXPECT_EQ(calc::highest_on_table(0.4), 1.8);
  EXPECT_EQ(calc::highest_on_table(0.89), 1.8);
  EXPECT_EQ(calc::highest_on_table(0.9), 1.9);
  EXPECT_EQ(calc::highest_on_table(3.0), 1.9);
}

// A luminous ball of 0.1 m in the middle of a sphere of radius R: all of the wall gets I / R^2 and
// the reflected light is the same everywhere, E = I / R^2 rho / (1 - rho), to any direction.
TEST(Ugr, OfOneSourceInAUniformFieldIsTheFormula) {
  constexpr double kCandela = 100.0, kRadius = 3.0, kReflectance = 0.5;
  const calc::PhotometricWeb ball =
      calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi}, {kCandela, kCandela},
                                 {calc::OpeningShape::ellipsoid, 0.1, 0.1, 0.1}, {});
  calc::PreparedScene scene;
  add_sphere(scene, kRadius, 5, kReflectance);
  add_luminaire(scene, ball, {0, 0, 0});
  set_extent(scene);
  const calc::SensorGrid grid = eyes({{-2, 0, -1}});
  const calc::PlaneField field = solve_eyes(scene, grid, 4096);
  const Measurement measured = measure_ugr(grid, field);
  ASSERT_TRUE(measured.metric);

  const double area_m2 = 3.14159265 * 0.05 * 0.05;
  const double luminance = kCandela / area_m2;
  const double solid_angle = area_m2 / 5.0;
  const double background = kCandela / 9.0 * 0.5 / 0.5 / 3.14159265;
  const double expected = 8.0 * std::log10(0.25 / background * luminance * luminance * solid_angle /
                                           (2.860161 * 2.860161));
  // The sphere is made of triangles: its wall is up to 0.3 % nearer.
  EXPECT_NEAR(measured.metric->estimate.value, expected, 0.05);
  EXPECT_LT(measured.metric->estimate.low, measured.metric->estimate.value);
  EXPECT_GT(measured.metric->estimate.high, measured.metric->estimate.value);
  EXPECT_LT(measured.metric->estimate.half_width(), 0.2);
}

// Four panels of 500 cd on their axis in two rows, seen from one end of the room: the two above
// x = 2 and 6 m. Everything by the panel's dimensions, with nothing of the program.
TEST(Ugr, OfAnInstallationIsTheHandComputedSum) {
  const calc::PhotometricWeb web = lambert_web(500.0, 720, kPanel);
  const std::vector<glm::dvec3> panels_m{
      {3, 1.5, 2.8}, {3, 4.5, 2.8}, {6, 1.5, 2.8}, {6, 4.5, 2.8}};
  const calc::PreparedScene scene = room_with(web, panels_m);
  const glm::dvec3 eye_m(0.5, 2.5, 1.2);
  const calc::SensorGrid grid = eyes({eye_m});
  const calc::PlaneField field = solve_eyes(scene, grid, 4096);

  double sum = 0.0;
  for (const glm::dvec3& panel_m : panels_m) {
    const double ahead = panel_m.x - 0.5, aside = std::abs(panel_m.y - 2.5), above = 1.6;
    const double r2 = ahead * ahead + aside * aside + above * above;
    const double cosine = above / std::sqrt(r2);
    const double luminance = 500.0 / 0.36;          // I cos / (A cos)
    const double solid_angle = 0.36 * cosine / r2;  // A cos / r^2
    const double t = std::atan2(aside, above) * 57.29577951;
    const double s = std::atan(std::sqrt(aside * aside + above * above) / ahead) * 57.29577951;
    const double index =
        std::exp((35.2 - 0.31889 * t - 1.22 * std::exp(-2.0 * t / 9.0)) / 1000 * s +
                 (21.0 + 0.26667 * t - 0.002963 * t * t) / 100000 * s * s);
    sum += luminance * luminance * solid_angle / (index * index);
  }
  ASSERT_EQ(field.glare.value.size(), 1u);
  EXPECT_NEAR(field.glare.value[0] / sum, 1.0, 1e-5);
  EXPECT_EQ(field.glare.low[0], field.glare.value[0]);
  EXPECT_EQ(field.glare.high[0], field.glare.value[0]);
  // The eye's illuminance is that of reflected light alone.
  EXPECT_EQ(field.direct_exact_lx[0], 0.0);
  EXPECT_TRUE(field.direct_sampled_lx.empty());
  const double background = mean_indirect_lx(field, 0) / 3.14159265;
  EXPECT_GT(background, 0.0);
  EXPECT_NEAR(measure_ugr(grid, field).metric->estimate.value,
              8.0 * std::log10(0.25 / background * sum), 1e-4);
}

// The background is what a planar receiver facing the line of sight gets of reflected light.
TEST(Ugr, BackgroundIsTheVerticalIlluminanceOfReflectedLight) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
  const calc::SensorGrid grid = eyes({{0.5, 2.5, 1.2}, {6, 3, 1.2}});
  calc::SensorGrid plane = grid;
  plane.derived = calc::DerivedQuantity::none;
  EXPECT_EQ(solve_eyes(scene, grid).indirect_lx, solve_eyes(scene, plane).indirect_lx);
}

// What tells two results apart: the rating without each replicate of the background.
TEST(Ugr, WithoutAReplicateIsTheRatingOfTheOthers) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::SensorGrid grid = eyes({{0.5, 2.5, 1.2}});
  const calc::PlaneField field = solve_eyes(room_with(web, {{3, 3, 2.8}}), grid, 64);
  const Measurement result = measure_ugr(grid, field);
  ASSERT_EQ(result.without_replicate.size(), field.replicates);
  const double mean_lx = mean_indirect_lx(field, 0);
  const auto count = static_cast<double>(field.replicates);
  for (std::size_t r = 0; r < field.replicates; ++r) {
    const double others_lx =
        (count * mean_lx - field.indirect_lx[r * field.points]) / (count - 1.0);
    EXPECT_NEAR(result.without_replicate[r] - result.metric->estimate.value,
                8.0 * std::log10(mean_lx / others_lx), 1e-9);
  }
}

// One more luminaire adds its own part to the sum (and light to the background, which may outweigh
// it); a brighter room lowers the rating, and one moved out of the field changes nothing but that.
TEST(Ugr, RisesWithTheSumAndFallsWithTheBackground) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::SensorGrid grid = eyes({{0.5, 2.5, 1.2}});
  const auto field = [&](const std::vector<glm::dvec3>& panels_m, double reflectance) {
    return solve_eyes(room_with(web, panels_m, reflectance), grid);
  };
  const auto ugr = [&](const calc::PlaneField& of) {
    return measure_ugr(grid, of).metric->estimate.value;
  };
  const calc::PlaneField near = field({{3, 2, 2.8}}, 0.5), far = field({{6, 2, 2.8}}, 0.5),
                         both = field({{3, 2, 2.8}, {6, 2, 2.8}}, 0.5);
  EXPECT_NEAR(both.glare.value[0], near.glare.value[0] + far.glare.value[0],
              1e-9 * both.glare.value[0]);
  EXPECT_GT(ugr(field({{3, 2, 2.8}, {6, 2, 2.8}}, 0.2)), ugr(both) + 1.0);
  // Straight above the eye, three times as high as far: out of the field.
  const calc::PlaneField above = field({{3, 2, 2.8}, {1.0, 2.5, 2.8}}, 0.5);
  EXPECT_EQ(above.glare.value[0], near.glare.value[0]);
  EXPECT_LT(ugr(above), ugr(near));
}

// 8 log10 of the dimming level: L^2 falls with its square, the background with itself.
TEST(Ugr, FollowsTheDimmingLevel) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  calc::PreparedScene scene = room_with(web, {{3, 2, 2.8}, {6, 2, 2.8}});
  scene.channels = {{"all", 0.8}};
  const calc::SensorGrid grid = eyes({{0.5, 2.5, 1.2}});
  const calc::PlaneField field = solve_eyes(scene, grid);
  rules::Requirement requirement;
  requirement.metric = rules::Metric::maximum;
  requirement.scene = "half";
  const std::vector<calc::LightScene> scenes{{"half", {{"all", 0.5}}, {}}};
  EXPECT_NEAR(rules::measure(requirement, grid, field, scenes, 0.95).metric->estimate.value -
                  measure_ugr(grid, field).metric->estimate.value,
              8.0 * std::log10(0.4), 1e-9);
}

// The point that names the maximum is the grid's; observers without a source do not matter to it.
TEST(Ugr, MaximumIsOfTheObserversThatSeeASource) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
  const calc::SensorGrid grid = eyes({{6, 3, 1.2}, {0.5, 3, 1.2}, {1.2, 3, 1.2}});
  const calc::PlaneField field = solve_eyes(scene, grid);
  EXPECT_EQ(field.glare.value[0], 0.0);  // behind
  const Measurement measured = measure_ugr(grid, field);
  ASSERT_TRUE(measured.metric);
  EXPECT_EQ(measured.metric->point, 1u);
  EXPECT_EQ(measured.points_used, 3u);
}

// Less than every limit, and with the reason.
TEST(Ugr, IsMetWhereNobodySeesASource) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
  const calc::SensorGrid grid = eyes({{6, 3, 1.2}});
  const calc::PlaneField field = solve_eyes(scene, grid);
  const Measurement measured = measure_ugr(grid, field);
  ASSERT_TRUE(measured.metric);
  EXPECT_TRUE(calc::is_nothing(measured.metric->estimate));
  rules::Finding finding = rules::judge_measurement(at_most(19.0), measured, grid);
  EXPECT_EQ(finding.verdict, rules::Verdict::pass);
  EXPECT_EQ(finding.reason, measured.nothing_there);
  EXPECT_NE(finding.reason.english().find("no observer sees"), std::string::npos);
  EXPECT_FALSE(finding.place_m);
  rules::Requirement at_least = at_most(19.0);
  at_least.comparison = rules::Comparison::at_least;
  EXPECT_EQ(rules::judge_measurement(at_least, measured, grid).verdict, rules::Verdict::fail);
  // Nor is more light needed for it.
  const rules::StopRule rule{rules::Goal::accuracy, 1e-6, 0.95};
  EXPECT_TRUE(rules::judge_look(rule, {at_most(19.0)}, grid, field, {}).finished);
}

// Without any light there is nothing that could be met.
TEST(Ugr, IsNotJudgedInTheDark) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}}, 0.0);
  const calc::SensorGrid grid = eyes({{6, 3, 1.2}});
  const Measurement measured = measure_ugr(grid, solve_eyes(scene, grid));
  EXPECT_FALSE(measured.metric);
  EXPECT_NE(measured.reason.english().find("no reflected light"), std::string::npos)
      << measured.reason;
}

TEST(Ugr, IsNotJudgedInABlackRoom) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}}, 0.0);
  const calc::SensorGrid grid = eyes({{0.5, 3, 1.2}});
  const Measurement measured = measure_ugr(grid, solve_eyes(scene, grid));
  EXPECT_FALSE(measured.metric);
  EXPECT_NE(measured.reason.english().find("no reflected light"), std::string::npos)
      << measured.reason;
}

// With the doubt that it has, of the second eye only: the first one has all of it behind or out of
// the field.
calc::GlareField doubted(const calc::PreparedScene& scene, const glm::dvec3& eye_m,
                         calc::GlareProblem problem, const char* words) {
  const calc::SensorGrid grid = eyes({{1.0, 0.5, 1.2}, eye_m});
  const calc::PlaneField field = solve_eyes(scene, grid, 64);
  EXPECT_EQ(field.glare.doubts.size(), 1u);
  if (!field.glare.doubts.empty()) {
    EXPECT_EQ(field.glare.doubts[0].point, 1u);
    EXPECT_EQ(field.glare.doubts[0].problem, problem);
  }
  const Measurement measured = measure_ugr(grid, field);
  EXPECT_NE(measured.remark.english().find(words), std::string::npos) << measured.remark;
  EXPECT_NE(measured.remark.english().find("observer 2"), std::string::npos) << measured.remark;
  return field.glare;
}

// A sphere of 0.2 m and 50 cd, 0.8 m ahead and 0.4 m below: r = 0.5, p = 1 + 0.8 r.
TEST(Ugr, BelowTheLineOfSightIsBetweenNothingAndIwata) {
  const calc::PhotometricWeb lamp = calc::PhotometricWeb::make(
      {0.0}, {0.0, calc::kPi}, {50.0, 50.0}, {calc::OpeningShape::ellipsoid, 0.2, 0.2, 0.2}, {});
  const calc::GlareField glare =
      doubted(room_with(lamp, {{0.9, 3, 0.8}}), {0.1, 3, 1.2}, calc::GlareProblem::below_sight,
              "below the line of sight");
  EXPECT_EQ(glare.value[1], 0.0);
  EXPECT_EQ(glare.low[1], 0.0);
  const double area_m2 = calc::kPi * 0.1 * 0.1;
  // Parts of it are a little nearer to the line of sight, and others farther: p differs by up to 15
  // %.
  EXPECT_NEAR(glare.high[1] * area_m2 * 0.8 * 1.4 * 1.4 / (50.0 * 50.0), 1.0, 0.05);
}

// Iwata's index by hand, on both pieces and at its end; the upper half has none.
TEST(IwataIndex, IsThatOfItsTwoPieces) {
  EXPECT_NEAR(calc::iwata_index({1, 0, -0.3}, kAhead).value(), 1.24, 1e-12);
  EXPECT_NEAR(calc::iwata_index({2, 1.2, -1.6}, kAhead).value(), 2.2, 1e-12);
  EXPECT_NEAR(calc::iwata_index({1, 2.9, -1.9}, kAhead).value(), 4.6, 1e-12);
  EXPECT_FALSE(calc::iwata_index({1, 0, 0.3}, kAhead));
  EXPECT_FALSE(calc::iwata_index({1, 0, -2.1}, kAhead));
}

// 500 cos 45 cd at sqrt(1.28) m, 45 degrees up: as one of 0.005 m2, and in the lower end not.
TEST(Ugr, OfASourceWithoutAreaIsAtMostThatOfTheSmallest) {
  const calc::PhotometricWeb point = lambert_web(500.0, 90);
  const calc::GlareField glare = doubted(room_with(point, {{0.9, 3, 2.8}}), {0.1, 3, 2.0},
                                         calc::GlareProblem::no_area, "no luminous area");
  const double squares = 0.5 * 500.0 * 500.0 / (0.005 * 1.28);
  EXPECT_NEAR(glare.high[1] * 7.059329 * 7.059329 / squares, 1.0, 1e-3);
  EXPECT_EQ(glare.value[1], glare.high[1]);
  EXPECT_EQ(glare.low[1], 0.0);
}

TEST(Ugr, OfALargeSourceSaysSo) {
  const calc::PhotometricWeb panel = lambert_web(500.0, 90, kPanel);
  const calc::GlareField glare = doubted(room_with(panel, {{0.4, 3, 2.8}}), {0.1, 3, 2.6},
                                         calc::GlareProblem::too_large, "fills");
  EXPECT_GT(glare.value[1], 0.0);
}

// One eye without noise that sees a source too large for the formula.
rules::GlarePoints eye_with_large_source(double sum, double background_lx) {
  rules::PointValues indirect;
  indirect.points = indirect.replicates = 1;
  indirect.value_lx = {background_lx};
  calc::GlareField glare;
  glare.value = glare.low = glare.high = {sum};
  glare.doubts = {{0, 0, calc::GlareProblem::too_large, 0.2, {}}};
  return {indirect, glare, {1.0}, {0}};
}

// Einhorn's formula for luminous ceilings, with any direct light at all, lies between the plain one
// and the upper end, and that with 500 lx of CIE 55 below it, too.
TEST(Ugr, OfALargeSourceIsAtMostThatOfALuminousCeiling) {
  constexpr double kSum = 5.0e4;
  for (const double background_lx : {20.0, 219.0, 221.0, 900.0}) {
    const rules::GlarePoints eye = eye_with_large_source(kSum, background_lx);
    const rules::Limits limits = eye.limits(0, 0.0);
    EXPECT_NEAR(limits.value, 8.0 * std::log10(0.25 * calc::kPi * kSum / background_lx), 1e-9);
    EXPECT_EQ(limits.low, limits.value);
    double most = 0.0;
    for (double direct_lx = 0.0; direct_lx < 1.0e6; direct_lx = 1.5 * direct_lx + 1.0) {
      for (const double middle_lx : {220.0, 500.0}) {
        const double einhorn = 8.0 * std::log10(2.0 * kSum * (1.0 + direct_lx / middle_lx) /
                                                (direct_lx + background_lx));
        EXPECT_LE(einhorn, limits.high + 1e-9);
        most = std::max(most, einhorn);
      }
    }
    EXPECT_NEAR(most, limits.high, 0.01) << background_lx;  // no more than is needed
    EXPECT_TRUE(eye.has_inexact_sources());
    EXPECT_EQ(eye.without_doubts().limits(0, 0.0).high, limits.value);
  }
}

// 8 log10(8 / pi) = 3.25 between both ends: no light path decides a limit in there.
TEST(Ugr, OfALargeSourceStopsWhereSamplesCannotDecide) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 720, {calc::OpeningShape::rectangle, 0.85, 0.85, 0.0});
  const calc::SensorGrid grid = eyes({{1.9, 3, 1.2}});
  const calc::PlaneField field = solve_eyes(room_with(web, {{3, 3, 2.8}}), grid, 4096);
  const auto measured_against = [&](double limit) {
    return rules::measure(at_most(limit), grid, field, {}, 0.95);
  };
  const double value = measured_against(19.0).metric->estimate.value;
  const auto is_finished = [&](double limit) {
    const rules::StopRule rule{rules::Goal::verdict, 0.01, 0.95};
    return rules::judge_look(rule, {at_most(limit)}, grid, field, {}).finished.has_value();
  };
  EXPECT_TRUE(measured_against(value + 1.6).is_open_for_good);
  EXPECT_TRUE(is_finished(value + 1.6));
  for (const double limit : {value - 2.0, value + 5.0}) {
    EXPECT_FALSE(measured_against(limit).is_open_for_good) << limit;
    EXPECT_TRUE(is_finished(limit)) << limit;
  }
  const auto verdict = [&](double limit) {
    return rules::judge_measurement(at_most(limit), measured_against(limit), grid).verdict;
  };
  EXPECT_EQ(verdict(value - 2.0), rules::Verdict::fail);
  EXPECT_EQ(verdict(value + 1.6), rules::Verdict::undecided);
  EXPECT_EQ(verdict(value + 5.0), rules::Verdict::pass);
  // At the lower end more samples would tell.
  const calc::PlaneField few = solve_eyes(room_with(web, {{3, 3, 2.8}}), grid, 4);
  EXPECT_FALSE(rules::measure(at_most(value), grid, few, {}, 0.95).is_open_for_good);
}

// Flat panels of 0.36 m2 count however far away they are; of small ones the milder rule for them
// makes the lower end.
TEST(Ugr, OfASmallSourceCountsAsTheSmallestInTheLowerEnd) {
  const auto glare_of = [&](double side_m, const glm::dvec3& from_eye) {
    const calc::PhotometricWeb web =
        lambert_web(500.0, 720, {calc::OpeningShape::rectangle, side_m, side_m, 0.0});
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, {40, 6, 4}, 0.5);
    const glm::dvec3 eye_m(1, 3, 1.2);
    add_luminaire(scene, web, eye_m + from_eye);
    set_extent(scene);
    return solve_eyes(scene, eyes({eye_m}), 64).glare;
  };
  const calc::GlareField far = glare_of(0.6, {15.5, 0, 2});
  EXPECT_GT(far.value[0], 0.0);
  EXPECT_EQ(far.low[0], far.value[0]);
  EXPECT_EQ(far.high[0], far.value[0]);
  const glm::dvec3 near(3, 0, 1.5);
  const double seen_m2 = 0.05 * 0.05 * near.z / glm::length(near);
  const calc::GlareField small = glare_of(0.05, near);
  EXPECT_NEAR(small.low[0] / small.value[0], seen_m2 / 0.005, 1e-6);
  EXPECT_EQ(small.high[0], small.value[0]);
  EXPECT_TRUE(small.doubts.empty());
}

// What a panel of 4 cm at this place gives.
calc::GlareField field_of_small_source(const glm::dvec3& from_eye) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 90, {calc::OpeningShape::rectangle, 0.04, 0.04, 0.0});
  const glm::dvec3 eye_m(1, 3, 1.2);
  return solve_eyes(room_with(web, {eye_m + from_eye}), eyes({eye_m}), 64).glare;
}

// The grid of UGR tables has its first row at half the height of the eye below the luminaires. The
// centre decides: also the half of a panel that is nearer to the line of sight is not on the table.
TEST(Ugr, OfASourceAtTwiceItsDistanceIsNothing) {
  for (const double aside : {0.0, 0.4, 1.2}) {
    const calc::GlareField glare = field_of_small_source({0.8, aside, 1.6});
    EXPECT_EQ(glare.high[0], 0.0) << aside;
    EXPECT_TRUE(glare.doubts.empty());
  }
}

// Between the end of the table and 2 it is open whether a source counts.
TEST(Ugr, OfASourceAboveTheTableIsOpenDownwards) {
  struct Place {
    double aside, above;
    bool is_on_table;
  };
  for (const Place& at :
       {Place{0.0, 1.65, true}, Place{0.0, 1.75, false}, Place{0.5, 1.75, true},
        Place{0.5, 1.85, false}, Place{1.0, 1.85, true}, Place{1.0, 1.95, false}}) {
    const glm::dvec3 from_eye = 0.8 * glm::dvec3(1, at.aside, at.above);
    const calc::GlareField glare = field_of_small_source(from_eye);
    const double r2 = glm::dot(from_eye, from_eye),
                 index = calc::guth_index(from_eye, kAhead).value();
    const double cosine = from_eye.z / std::sqrt(r2), area_m2 = 0.04 * 0.04;
    const double sum = 500.0 * 500.0 / area_m2 * cosine / r2 / (index * index);
    EXPECT_NEAR(glare.value[0] / sum, 1.0, 1e-3) << at.aside << " " << at.above;
    EXPECT_EQ(glare.high[0], glare.value[0]);
    const double milder = area_m2 * cosine / 0.005;  // it is smaller than that
    EXPECT_NEAR(glare.low[0], at.is_on_table ? milder * glare.value[0] : 0.0, 1e-6 * glare.value[0])
        << at.aside << " " << at.above;
  }
}

// A panel whose centre is above the table, but not the far quarter of it: the lower end has that.
TEST(Ugr, OfASourcePartlyAboveTheTableHasTheRestInItsLowerEnd) {
  const double ahead_m = 0.9, above_m = 1.6, length_m = 0.4, width_m = 0.1;
  const calc::PhotometricWeb web =
      lambert_web(500.0, 720, {calc::OpeningShape::rectangle, length_m, width_m, 0.0});
  const calc::GlareField glare =
      solve_eyes(room_with(web, {{3, 3, 1.2 + above_m}}), eyes({{3 - ahead_m, 3, 1.2}}), 64).glare;
  double weights = 0.0;
  constexpr int kParts = 100000;
  for (int k = 0; k < kParts; ++k) {
    const double x = ahead_m + length_m * ((k + 0.5) / kParts - 0.5);
    if (above_m > 1.7 * x) continue;
    weights += 1.0 / std::pow(calc::guth_index({x, 0, above_m}, kAhead).value(), 2) / kParts;
  }
  const double r2 = above_m * above_m + ahead_m * ahead_m, area_m2 = length_m * width_m;
  const double squares = 500.0 * 500.0 / area_m2 * above_m / std::sqrt(r2) / r2;
  EXPECT_GT(weights, 0.0);
  EXPECT_NEAR(glare.low[0] / (squares * weights), 1.0, 0.05);
  EXPECT_NEAR(glare.value[0] /
                  (squares / std::pow(calc::guth_index({ahead_m, 0, above_m}, kAhead).value(), 2)),
              1.0, 1e-3);
  EXPECT_EQ(glare.high[0], glare.value[0]);
}

// Nothing of it may go unsaid, also where the field ends.
TEST(Ugr, DoubtsASourceAtTwiceItsDistanceBelow) {
  const calc::PhotometricWeb lamp = calc::PhotometricWeb::make(
      {0.0}, {0.0, calc::kPi}, {50.0, 50.0}, {calc::OpeningShape::ellipsoid, 0.04, 0.04, 0.04}, {});
  const calc::GlareField glare =
      solve_eyes(room_with(lamp, {{1.5, 3, 0.2}}), eyes({{1, 3, 1.2}}), 64).glare;
  ASSERT_EQ(glare.doubts.size(), 1u);
  EXPECT_EQ(glare.doubts[0].problem, calc::GlareProblem::below_sight);
  EXPECT_EQ(glare.value[0], 0.0);
  EXPECT_GT(glare.high[0], 0.0);
}

// A strip of 2.4 m overhead: its centre is 76 degrees above the line of sight and out of the field,
// but what lies more than 0.94 m ahead is on the table and counts, each part with its own index.
TEST(Ugr, OfALongSourceCountsThePartsInTheField) {
  const double length_m = 2.4, width_m = 0.06, above_m = 1.6, ahead_m = 0.4;
  const calc::PhotometricWeb web =
      lambert_web(500.0, 900, {calc::OpeningShape::rectangle, length_m, width_m, 0.0});
  const calc::PreparedScene scene = room_with(web, {{3, 3, 1.2 + above_m}});
  const calc::PlaneField field = solve_eyes(scene, eyes({{3 - ahead_m, 3, 1.2}}), 64);
  const double r2 = above_m * above_m + ahead_m * ahead_m;
  const double cosine = above_m / std::sqrt(r2);
  constexpr int kParts = 100000;
  double weights = 0.0;
  for (int k = 0; k < kParts; ++k) {
    const double x = ahead_m + length_m * ((k + 0.5) / kParts - 0.5);
    const auto index = calc::guth_index({x, 0, above_m}, kAhead);
    if (index && above_m <= calc::highest_on_table(0.0) * x)
      weights += 1.0 / (*index * *index * kParts);
  }
  const double luminance = 500.0 / (length_m * width_m);
  const double solid_angle_sr = length_m * width_m * cosine / r2;
  EXPECT_GT(weights, 0.0);
  EXPECT_NEAR(field.glare.value[0] / (luminance * luminance * solid_angle_sr * weights), 1.0, 0.01);
}

// Sum of L^2 w / p^2 over a lambertian ceiling panel, part by part, of those in the field only, or
// of those that have an index on the table.
double sum_of_parts(double length_m, double width_m, double ahead_m, double above_m,
                    bool on_table_only = false) {
  constexpr int kParts = 1000;
  const double area_m2 = length_m * width_m, luminance = 500.0 / area_m2;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    for (int j = 0; j < kParts; ++j) {
      const glm::dvec3 to(ahead_m + length_m * ((i + 0.5) / kParts - 0.5),
                          width_m * ((j + 0.5) / kParts - 0.5), above_m);
      const auto index = calc::guth_index(to, kAhead);
      if (!index) continue;
      const bool is_on_table = above_m <= calc::highest_on_table(std::abs(to.y) / to.x) * to.x;
      if (on_table_only && !is_on_table) continue;
      const double r = glm::length(to);
      sum += area_m2 / kParts / kParts * above_m / (r * r * r) / (*index * *index);
    }
  }
  return luminance * luminance * sum;
}

// The same as one source far away.
double sum_by_centre(double length_m, double width_m, double ahead_m, double above_m) {
  const double r = std::hypot(ahead_m, above_m), area_m2 = length_m * width_m;
  const double index = calc::guth_index({ahead_m, 0, above_m}, kAhead).value();
  return 500.0 * 500.0 / area_m2 * above_m / (r * r * r) / (index * index);
}

// A panel of 0.85 m, 1.1 m ahead and 1.6 m above: 0.16 sr, of which a screen leaves half.
TEST(Ugr, OfALargeSourceJudgesWhatIsSeen) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 720, {calc::OpeningShape::rectangle, 0.85, 0.85, 0.0});
  const calc::SensorGrid grid = eyes({{1.9, 3, 1.2}});
  calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
  const calc::PlaneField open = solve_eyes(scene, grid, 64);
  ASSERT_EQ(open.glare.doubts.size(), 1u);
  EXPECT_EQ(open.glare.doubts[0].problem, calc::GlareProblem::too_large);
  EXPECT_NEAR(open.glare.value[0] / sum_of_parts(0.85, 0.85, 1.1, 1.6), 1.0, 0.01);
  add_quad(scene, {2.1, 3.0, 1.0}, {0, 1.0, 0}, {0, 0, 1.79}, 0.5);
  set_extent(scene);
  const calc::PlaneField half = solve_eyes(scene, grid, 64);
  EXPECT_TRUE(half.glare.doubts.empty());
  // Of both ways to count: half of it, a row of lines up and down.
  const double parts = sum_of_parts(0.85, 0.85, 1.1, 1.6);
  const double centre = sum_by_centre(0.85, 0.85, 1.1, 1.6);
  const double row = 1.0 / 16.0;
  EXPECT_NEAR(half.glare.value[0] / (0.5 * parts), 1.0, 0.01);
  // The row that is in doubt may be the one that gives the most, less than three times the mean.
  EXPECT_GE(half.glare.high[0], (0.5 + row) * std::max(parts, centre) * 0.99);
  EXPECT_LE(half.glare.high[0], (0.5 + 3.0 * row) * std::max(parts, centre));
  EXPECT_LE(half.glare.low[0], (0.5 - row) * std::min(parts, centre) * 1.01);
  const double sure = sum_of_parts(0.85, 0.85, 1.1, 1.6, true);
  EXPECT_LT(sure, parts);
  EXPECT_GE(half.glare.low[0], (0.5 - 3.0 * row) * std::min(sure, centre));
}

// A strip of 2.4 x 0.2 m along the line of sight, its centre 0.85 m ahead and 1.6 m above: 0.13 sr,
// but what is more than 0.8 m ahead, and so in the field, has less than half of it.
TEST(Ugr, OfALargeSourceJudgesWhatLiesInTheField) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 720, {calc::OpeningShape::rectangle, 2.4, 0.2, 0.0});
  const calc::PlaneField field =
      solve_eyes(room_with(web, {{3, 3, 2.8}}), eyes({{3 - 0.85, 3, 1.2}}), 64);
  ASSERT_TRUE(field.glare.doubts.empty());
  const double parts = sum_of_parts(2.4, 0.2, 0.85, 1.6);
  const double centre = sum_by_centre(2.4, 0.2, 0.85, 1.6);
  EXPECT_NEAR(field.glare.value[0] / parts, 1.0, 0.02);
  // Neither a pass nor a fail is proved by the way of counting.
  EXPECT_LE(field.glare.low[0], std::min(parts, centre) * 1.02);
  EXPECT_GE(field.glare.high[0], std::max(parts, centre) * 0.98);
  // In doubt is a row of lines at the edge of the field, where sources count least.
  EXPECT_GE(field.glare.low[0], std::min(parts, centre) * 0.8);
  EXPECT_LE(field.glare.high[0], std::max(parts, centre) * 1.2);
}

// Behind a screen and below the line of sight: nothing of it counts, and nothing is in doubt.
TEST(Ugr, OfALargeSourceThatIsHiddenBelowIsNothing) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 90, {calc::OpeningShape::rectangle, 1.5, 1.5, 0.0});
  calc::PreparedScene scene = room_with(web, {{3, 3, 0.4}});
  add_quad(scene, {1.9, 1.0, 0.0}, {0, 4.0, 0}, {0, 0, 1.19}, 0.5);
  set_extent(scene);
  const calc::PlaneField field = solve_eyes(scene, eyes({{1.5, 3, 1.2}}), 64);
  EXPECT_EQ(field.glare.value[0], 0.0);
  EXPECT_TRUE(field.glare.doubts.empty());
}

// All of its light goes to the ceiling.
TEST(Ugr, OfALargeUplightIsNothing) {
  const calc::PhotometricWeb web = calc::PhotometricWeb::make(
      {0.0}, {0.0, 0.5 * calc::kPi, 0.5 * calc::kPi + 0.02, calc::kPi}, {0.0, 0.0, 900.0, 900.0},
      {calc::OpeningShape::rectangle, 1.2, 1.2, 0.0}, {});
  const calc::PlaneField field =
      solve_eyes(room_with(web, {{3, 3, 2.2}}), eyes({{1.9, 3, 1.2}}), 64);
  EXPECT_EQ(field.glare.high[0], 0.0);
  EXPECT_TRUE(field.glare.doubts.empty());
}

// 60 degrees of cut-off: the centre of a ceiling of 6 m does not shine into the eye, but what is
// nearer than its centre does.
TEST(Ugr, OfALargeSourceWithACutOffIsNotNothing) {
  const double cut = calc::kPi / 3.0;
  const calc::PhotometricWeb web = calc::PhotometricWeb::make(
      {0.0}, {0.0, cut, cut + 0.02, calc::kPi}, {9000.0, 9000.0, 0.0, 0.0},
      {calc::OpeningShape::rectangle, 6.0, 6.0, 0.0}, {});
  calc::PreparedScene scene;
  add_box(scene, {-10, -10, 0}, {20, 20, 3.0}, 0.5);
  add_luminaire(scene, web, {0, 0, 2.9});
  set_extent(scene);
  // The centre is 65 degrees from the vertical, the near edge 22.
  const calc::PlaneField field = solve_eyes(scene, eyes({{-3.7, 0, 1.2}}), 64);
  EXPECT_TRUE(!field.glare.doubts.empty() || field.glare.high[0] > 0.0);
}

// Wider, so that what lies in the field is too large itself.
TEST(Ugr, DoubtsALargeSourceInTheField) {
  const calc::PhotometricWeb web =
      lambert_web(500.0, 90, {calc::OpeningShape::rectangle, 2.4, 0.4, 0.0});
  const calc::PlaneField field =
      solve_eyes(room_with(web, {{3, 3, 2.8}}), eyes({{2.15, 3, 1.2}}), 64);
  ASSERT_EQ(field.glare.doubts.size(), 1u);
  EXPECT_GT(field.glare.doubts[0].number, 0.1);
  EXPECT_LT(field.glare.doubts[0].number, 0.17);  // of 0.26 sr
}

// A louvre of slats as wide as the gaps between them: half is seen, wherever the slats stand.
TEST(Ugr, CountsHalfOfAnOpeningBehindSlats) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::SensorGrid grid = eyes({{0.5, 3, 1.2}});
  const auto value_with = [&](int slats, double shift) {
    calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
    for (int k = 0; k < slats; ++k) {
      const double y = 2.7 + (k + shift) * 0.6 / slats;
      add_quad(scene, {2.6, y, 2.79}, {0.8, 0, 0}, {0, 0.3 / slats, 0}, 0.0);
    }
    set_extent(scene);
    return solve_eyes(scene, grid, 64).glare.value[0];
  };
  const double open = value_with(0, 0.0);
  for (const double shift : {0.0, 0.25, 0.5}) {
    EXPECT_NEAR(value_with(16, shift) / open, 0.5, 1.0 / 16.0) << shift;
  }
}

// 4 cm at 5 m: 4e-4 m2, and so in the lower end a twelfth of what CIE 117's formula has.
TEST(Ugr, OfASmallSourceHasAnIntervalThatSaysWhy) {
  const calc::PhotometricWeb panel = lambert_web(500.0, 90, kPanel);
  const calc::PhotometricWeb spot =
      lambert_web(100.0, 90, {calc::OpeningShape::disk, 0.04, 0.04, 0.0});
  calc::PreparedScene scene = room_with(spot, {{5.5, 3, 2.8}});
  const calc::SensorGrid grid = eyes({{0.5, 3, 1.2}});
  const Measurement alone = measure_ugr(grid, solve_eyes(scene, grid));
  ASSERT_TRUE(alone.metric);
  EXPECT_LT(alone.metric->estimate.low,
            alone.metric->estimate.value + 8.0 * std::log10(1.0 / 12.0));
  EXPECT_NE(alone.remark.english().find("Sources below 0.005 m²"), std::string::npos)
      << alone.remark;

  add_luminaire(scene, panel, {3, 3, 2.8});
  const calc::PlaneField field = solve_eyes(scene, grid);
  EXPECT_LT(field.glare.low[0], field.glare.value[0]);
  EXPECT_EQ(field.glare.high[0], field.glare.value[0]);
  const Measurement both = measure_ugr(grid, field);
  ASSERT_TRUE(both.metric);
  const double gap = 8.0 * std::log10(field.glare.high[0] / field.glare.low[0]);
  EXPECT_GT(both.metric->estimate.value - both.metric->estimate.low, gap);
  EXPECT_FALSE(both.remark.empty());
}

// A screen in front of the eye hides all, or the half of the panel beyond y = 3.
TEST(Ugr, CountsWhatIsSeenOfAnOpening) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::SensorGrid grid = eyes({{0.5, 3, 1.2}});
  const auto sum_behind = [&](double from_y, double to_y) {
    calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
    add_quad(scene, {1.0, from_y, 1.0}, {0, to_y - from_y, 0}, {0, 0, 1.5}, 0.5);
    set_extent(scene);
    const calc::PlaneField field = solve_eyes(scene, grid, 64);
    return std::array{field.glare.low[0], field.glare.value[0], field.glare.high[0]};
  };
  const auto open = sum_behind(4.5, 5.0), hidden = sum_behind(2.0, 4.0),
             half = sum_behind(3.0, 4.0);
  EXPECT_GT(open[1], 0.0);
  EXPECT_EQ(open[0], open[2]);
  EXPECT_EQ(hidden[2], 0.0);
  EXPECT_NEAR(half[1] / open[1], 0.5, 1e-9);
  EXPECT_NEAR(half[0] / open[1], 0.5 - 1.0 / 16.0, 1e-9);
  EXPECT_NEAR(half[2] / open[1], 0.5 + 1.0 / 16.0, 1e-9);
}

// A gap of a tenth of a millimetre between two screens, which no line of sight goes through:
// "nothing" is not known, and the upper end has a row of lines.
TEST(Ugr, WhatMayBeSeenThroughAGapIsInTheUpperEnd) {
  const calc::PhotometricWeb web = lambert_web(500.0, 90, kPanel);
  const calc::SensorGrid grid = eyes({{0.5, 3, 1.2}});
  calc::PreparedScene scene = room_with(web, {{3, 3, 2.8}});
  const double open = solve_eyes(scene, grid, 64).glare.value[0];
  add_quad(scene, {1.0, 1.0, 0.5}, {0, 2.04, 0}, {0, 0, 2.2}, 0.5);
  add_quad(scene, {1.0, 3.0401, 0.5}, {0, 2.0, 0}, {0, 0, 2.2}, 0.5);
  set_extent(scene);
  const calc::GlareField glare = solve_eyes(scene, grid, 64).glare;
  EXPECT_EQ(glare.low[0], 0.0);
  EXPECT_EQ(glare.value[0], 0.0);
  EXPECT_NEAR(glare.high[0] / open, 1.0 / 16.0, 1e-9);
  EXPECT_TRUE(glare.doubts.empty());
}

// Areas along a direction, of every shape.
TEST(SeenOpening, IsTheOutlineOfTheShape) {
  const auto area = [](calc::OpeningShape shape, const glm::dvec3& direction) {
    calc::PlacedLuminaire luminaire;
    luminaire.opening = {shape, 0.4, 0.2, 0.1};
    return calc::seen_opening_m2(luminaire, glm::normalize(direction));
  };
  using enum calc::OpeningShape;
  EXPECT_NEAR(area(rectangle, {0, 0, -1}), 0.08, 1e-12);
  EXPECT_NEAR(area(rectangle, {std::sqrt(3.0), 0, -1}), 0.04, 1e-12);
  EXPECT_NEAR(area(disk, {0, 0, -1}), calc::kPi * 0.02, 1e-12);
  EXPECT_NEAR(area(box, {1, 0, 0}), 0.02, 1e-12);
  EXPECT_NEAR(area(box, {0, 0, 1}), 0.08, 1e-12);
  EXPECT_NEAR(area(cylinder, {0, 1, 0}), 0.04, 1e-12);
  EXPECT_NEAR(area(ellipsoid, {0, 1, 0}), calc::kPi * 0.01, 1e-12);
  EXPECT_EQ(area(point, {0, 0, -1}), 0.0);
}

}  // namespace
}  // namespace glare_test
