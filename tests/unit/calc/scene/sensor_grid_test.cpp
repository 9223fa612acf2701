#include "calc/scene/sensor_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace calc::sensor_grid_test {
namespace {

std::vector<glm::dvec2> rectangle(double width_m, double depth_m) {
  return {{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}};
}

CalcPlane plane_of(std::vector<glm::dvec2> outline, GridRule grid, double z_m = 0.75) {
  PlanarArea area;
  area.origin_m = {0, 0, z_m};
  area.outline_m = std::move(outline);
  area.grid = grid;
  CalcPlane plane;
  plane.id = "desk";
  plane.where = {"project.xml", 7, 3};
  plane.area = area;
  return plane;
}

PlanarArea& area_of(CalcPlane& plane) { return std::get<PlanarArea>(plane.area); }

Body box(const std::string& id, glm::dvec3 lower, glm::dvec3 upper) {
  Body body;
  body.id = id;
  body.is_closed = true;
  for (int i = 0; i < 8; ++i) {
    body.vertex_m.emplace_back((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                               (i & 4) != 0 ? upper.z : lower.z);
  }
  body.triangle = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return body;
}

struct Made {
  std::optional<SensorGrid> grid;
  std::vector<std::string> messages;
};

Made make(const CalcPlane& plane, const Space& space = {}) {
  Diagnostics diagnostics;
  Made made;
  made.grid = make_sensor_grid(plane, space, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) made.messages.push_back(format_diagnostic(d));
  EXPECT_EQ(made.grid.has_value(), !diagnostics.has_errors());
  if (made.grid) {  // so much is known before any point is made
    EXPECT_EQ(planned_points(plane),
              static_cast<double>(made.grid->position_m.size() + made.grid->dropped.size()));
    EXPECT_GE(most_planned_points(plane), planned_points(plane));
  }
  return made;
}

std::size_t dropped_for(const SensorGrid& grid, DropReason reason) {
  return static_cast<std::size_t>(
      std::count_if(grid.dropped.begin(), grid.dropped.end(),
                    [&](const DroppedPoint& point) { return point.reason == reason; }));
}

void expect_counts(double u_m, double v_m, int columns, int rows, const GridByRule& rule = {}) {
  const GridCounts counts = grid_counts(rule, u_m, v_m);
  EXPECT_EQ(counts.columns, columns) << u_m << " x " << v_m;
  EXPECT_EQ(counts.rows, rows) << u_m << " x " << v_m;
}

// Sides and counts of the formula for squares; the example table printed in the standard has 3, 3,
// 12 and 17 for 0.4, 0.6, 25 and 50 m, because it rounds p first.
TEST(GridRuleEn12464, CountsOfSquaresFollowTheFormula) {
  expect_counts(0.4, 0.4, 4, 4);
  expect_counts(0.6, 0.6, 4, 4);
  expect_counts(1, 1, 5, 5);
  expect_counts(2, 2, 6, 6);
  expect_counts(5, 5, 8, 8);
  expect_counts(10, 10, 10, 10);
  expect_counts(25, 25, 13, 13);
  expect_counts(50, 50, 16, 16);
  expect_counts(100, 100, 20, 20);
}

GridByRule rounding_to(GridRounding rounding) {
  GridByRule rule;
  rule.rounding = rounding;
  return rule;
}

TEST(GridRuleEn12464, AllNineSizesRoundedUp) {
  const GridByRule up = rounding_to(GridRounding::up), odd = rounding_to(GridRounding::odd_up);
  const struct {
    double d_m;
    int up, odd_up;
  } cases[] = {{0.4, 4, 5},  {0.6, 5, 5},  {1, 5, 5},    {2, 7, 7},    {5, 9, 9},
               {10, 10, 11}, {25, 14, 15}, {50, 17, 17}, {100, 20, 21}};
  for (const auto& c : cases) {
    expect_counts(c.d_m, c.d_m, c.up, c.up, up);
    expect_counts(c.d_m, c.d_m, c.odd_up, c.odd_up, odd);
  }
}

// 5 x 4 m: 8.12 x 6.49 cells.
TEST(GridRuleEn12464, TheRoundingDecidesNextToAHalf) {
  expect_counts(5, 4, 8, 6);
  expect_counts(5, 4, 9, 7, rounding_to(GridRounding::up));
  expect_counts(4, 5, 7, 9, rounding_to(GridRounding::odd_up));
}

// log10 and pow leave noise: 10 / p = 10 must not become 11.
TEST(GridRuleEn12464, WholeQuotientsAreNotRoundedUp) {
  const GridByRule up = rounding_to(GridRounding::up);
  expect_counts(10.0, 10.0, 10, 10, up);
  expect_counts(10.0 * (1 + 1e-12), 10.0, 10, 10, up);
  expect_counts(10.0 * (1 + 1e-6), 10.0, 11, 10, up);  // p grows more slowly than d
}

TEST(GridRule, TheNumbersAreData) {
  GridByRule rule;
  rule.factor_m = 0.5;
  rule.base = 10.0;
  rule.max_spacing_m = 3.0;
  rule.shorter_from_ratio = 4.0;
  expect_counts(4, 2, 2, 1, rule);     // p = 2 m, d = 4 m although the sides have the ratio 2
  expect_counts(8, 2, 8, 2, rule);     // p = 1 m, d = 2 m
  expect_counts(30, 20, 10, 7, rule);  // p = 3 m instead of 15 m
}

TEST(GridRule, WhatIsPrintedLeadsFromTheSidesToTheCounts) {
  EXPECT_EQ(grid_words({}, 5, 4),
            "EN 12464-1 (p = 0.2 * 5^log10 d): d = 5 m, the longer side; p = 0.616 m; 8.12 x "
            "6.49 cells, rounded to the nearest whole number: 8 x 6");
  EXPECT_EQ(grid_words(rounding_to(GridRounding::up), 3, 6),
            "EN 12464-1 (p = 0.2 * 5^log10 d): d = 3 m, the shorter side, because the longer "
            "side is at least 2 times as long; p = 0.431 m; 6.96 x 13.92 cells, rounded up: 7 x "
            "14");
  EXPECT_EQ(grid_words(rounding_to(GridRounding::odd_up), 400, 400),
            "EN 12464-1 (p = 0.2 * 5^log10 d): d = 400 m, the longer side; p = 10 m, the largest "
            "allowed value; 40.00 x 40.00 cells, rounded up to an odd number: 41 x 41");
}

TEST(GridRuleEn12464, ASideRatioOfTwoTakesTheShorterSide) {
  expect_counts(5.9, 3.0, 9, 4);
  expect_counts(6.0, 3.0, 14, 7);
  expect_counts(3.0, 6.0, 7, 14);
  expect_counts(5.999999999, 3.0, 14, 7);
  expect_counts(5.9999, 3.0, 9, 4);
}

TEST(GridRuleEn12464, TheSpacingEndsAtTenMetres) { expect_counts(1000, 900, 100, 90); }

TEST(GridRuleEn12464, ThereIsAtLeastOneCell) { expect_counts(0.001, 400, 1, 250000); }

TEST(SensorGrid, PointsAreCellCentresInRowOrder) {
  CalcPlane plane = plane_of(rectangle(4, 2), GridByCount{4, 2});
  area_of(plane).origin_m = {10, 20, 0.75};
  area_of(plane).u = {0, 1, 0};
  area_of(plane).v = {-1, 0, 0};
  const Made made = make(plane);
  ASSERT_TRUE(made.grid);
  const SensorGrid& grid = *made.grid;
  EXPECT_EQ(grid.columns, 4);
  EXPECT_EQ(grid.rows, 2);
  EXPECT_EQ(grid.rule, "count");
  EXPECT_DOUBLE_EQ(grid.spacing_u_m, 1.0);
  EXPECT_DOUBLE_EQ(grid.spacing_v_m, 1.0);
  ASSERT_EQ(grid.position_m.size(), 8u);
  EXPECT_EQ(grid.position_m[0], glm::dvec3(9.5, 20.5, 0.75));
  EXPECT_EQ(grid.position_m[7], glm::dvec3(8.5, 23.5, 0.75));
  EXPECT_EQ(grid.normal[7], glm::dvec3(0, 0, 1));
  EXPECT_EQ(grid.column, (std::vector<int>{0, 1, 2, 3, 0, 1, 2, 3}));
  EXPECT_EQ(grid.row, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_TRUE(grid.dropped.empty());
}

TEST(SensorGrid, SpacingIsNeverLargerThanAskedFor) {
  const Made made = make(plane_of(rectangle(4.1, 2.0), GridBySpacing{1.0, 0.5, {}}));
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->columns, 5);
  EXPECT_EQ(made.grid->rows, 4);
  EXPECT_EQ(made.grid->rule, "spacing");
  // 0.3 / 0.1 is a little less than 3, 0.6 / 0.2 a little more than it should be.
  const Made thirds = make(plane_of(rectangle(0.3, 0.6), GridBySpacing{0.1, 0.2, {}}));
  ASSERT_TRUE(thirds.grid);
  EXPECT_EQ(thirds.grid->columns, 3);
  EXPECT_EQ(thirds.grid->rows, 3);
}

TEST(SensorGrid, TheMarginComesOffBeforeTheRuleIsApplied) {
  CalcPlane plane = plane_of(rectangle(7.0, 4.0), GridByRule{});
  area_of(plane).margin_m = 0.5;
  const Made made = make(plane);
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->columns, 14);
  EXPECT_EQ(made.grid->rows, 7);
  EXPECT_EQ(made.grid->rule, grid_words({}, 6.0, 3.0));
  EXPECT_EQ(made.grid->margin_m, 0.5);
  EXPECT_EQ(made.grid->origin_m, glm::dvec3(0.5, 0.5, 0.75));
  EXPECT_NEAR(made.grid->position_m[0].x, 0.5 + 6.0 / 28.0, 1e-12);
  EXPECT_EQ(made.grid->position_m.size(), 98u);
  EXPECT_TRUE(made.grid->dropped.empty());
  EXPECT_TRUE(made.messages.empty());
}

TEST(SensorGrid, AMarginThatLeavesNothingIsAnError) {
  CalcPlane plane = plane_of(rectangle(4, 1), GridByRule{});
  area_of(plane).margin_m = 0.5;
  const Made made = make(plane);
  EXPECT_EQ(made.messages,
            std::vector<std::string>{
                "project.xml:7:3: error[grid-margin-too-large]: plane 'desk' cannot be judged: a "
                "margin of 0.5 m leaves nothing of the area of 4 m x 1 m; use a smaller margin"});
}

TEST(SensorGrid, PointsOutsideAConcaveOutlineAreDropped) {
  const Made made =
      make(plane_of({{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}}, GridByCount{6, 5}));
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->position_m.size(), 21u);
  EXPECT_EQ(dropped_for(*made.grid, DropReason::outside_area), 9u);
  EXPECT_EQ(made.grid->columns, 6) << "cells are numbered over the whole rectangle";
}

// An arm of 1.2 x 4 m beside a body of 6 x 4 m; cells of 3 x 4 m have their centres in the body.
// The last 2 m of the arm are more than a cell away, and some more is behind its corner.
const std::vector<glm::dvec2> kArm{{0, 0}, {6, 0}, {6, 4}, {1.2, 4}, {1.2, 8}, {0, 8}};

TEST(SensorGrid, GivenCellsThatMissAnArmAreWarnedOf) {
  const std::string expected =
      "project.xml:7:3: warning[grid-misses-part]: plane 'desk': its grid leaves 2.7 m2 of the "
      "area, at (";
  for (const GridRule& rule : {GridRule(GridByCount{2, 2}), GridRule(GridBySpacing{3, 4, {}})}) {
    const Made made = make(plane_of(kArm, rule));
    ASSERT_EQ(made.messages.size(), 1u);
    EXPECT_EQ(made.messages[0].substr(0, expected.size()), expected);
    EXPECT_EQ(made.grid->position_m.size(), 2u);  // as asked for
  }
}

TEST(SensorGrid, GivenCellsThatReachEveryPartAreNot) {
  EXPECT_EQ(make(plane_of(kArm, GridByCount{10, 8})).messages, std::vector<std::string>());
  // Whole rectangles are reached by whatever cells somebody wants.
  EXPECT_EQ(make(plane_of(rectangle(9, 7), GridByCount{1, 1})).messages,
            std::vector<std::string>());
  // 0.1 x 3 m between cells of 0.3 m, less than a cell of EN 12464-1 (0.7 m).
  const std::vector<glm::dvec2> sliver{{0, 0}, {6, 0}, {6, 3}, {0.1, 3}, {0.1, 6}, {0, 6}};
  EXPECT_EQ(make(plane_of(sliver, GridByCount{20, 20})).messages, std::vector<std::string>());
}

TEST(SensorGrid, TheMarginFollowsAConcaveOutline) {
  CalcPlane plane =
      plane_of({{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}}, GridBySpacing{0.5, 0.5, {}});
  area_of(plane).margin_m = 0.5;
  const Made made = make(plane);
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->columns, 10);
  EXPECT_EQ(made.grid->rows, 8);
  // Centres at 0.75, 1.25, ...: 2 full rows below y = 1.5, then 6 rows of 4 up to x = 2.5. Outside
  // are 5 x 5; the margin takes 6 of row y = 1.75 (that near the inner corner too) and the 5 of
  // column x = 2.75 above it.
  EXPECT_EQ(made.grid->position_m.size(), 20u + 24u);
  EXPECT_EQ(dropped_for(*made.grid, DropReason::outside_area), 25u);
  EXPECT_EQ(dropped_for(*made.grid, DropReason::within_margin), 11u);
  for (const glm::dvec3& point : made.grid->position_m) {
    EXPECT_TRUE(point.y < 1.5 || point.x < 2.5) << point.x << " " << point.y;
  }
}

TEST(SensorGrid, HolesAreNotPartOfTheAreaAndHaveNoMargin) {
  CalcPlane plane = plane_of(rectangle(5, 5), GridByCount{4, 4});
  area_of(plane).margin_m = 0.5;
  area_of(plane).holes_m = {{{1.2, 1.2}, {3.4, 1.2}, {3.4, 2.9}, {1.2, 2.9}}};
  const Made made = make(plane);  // points at 1, 2, 3, 4
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(dropped_for(*made.grid, DropReason::outside_area), 2u) << "(2, 2) and (3, 2)";
  EXPECT_EQ(made.grid->position_m.size(), 14u) << "(2, 1) is 0.2 m from the hole and stays";
}

TEST(SensorGrid, PointsOutsideTheRoomAreDroppedAndItsBoundaryIsNot) {
  Space space;
  space.shell = RoomShell{{{0, 0}, {2, 0}, {2, 4}, {0, 4}}, 0.0, 2.5};
  const Made sideways = make(plane_of(rectangle(4, 4), GridByCount{4, 4}), space);
  ASSERT_TRUE(sideways.grid);
  EXPECT_EQ(sideways.grid->position_m.size(), 8u);
  EXPECT_EQ(dropped_for(*sideways.grid, DropReason::outside_room), 8u);
  for (const double z_m : {0.0, 2.5}) {
    EXPECT_TRUE(make(plane_of(rectangle(2, 4), GridByCount{2, 2}, z_m), space).grid) << z_m;
  }
  for (const double z_m : {-0.001, 2.501}) {
    EXPECT_FALSE(make(plane_of(rectangle(2, 4), GridByCount{2, 2}, z_m), space).grid) << z_m;
  }
  CalcPlane wall = plane_of(rectangle(4, 2), GridByCount{4, 2}, 0.2);
  area_of(wall).origin_m = {2, 0, 0.2};
  area_of(wall).u = {0, 1, 0};
  area_of(wall).v = {0, 0, 1};
  const Made on_wall = make(wall, space);
  ASSERT_TRUE(on_wall.grid);
  EXPECT_EQ(on_wall.grid->position_m.size(), 8u) << "a wall is a boundary";
}

TEST(SensorGrid, TheRoomsBoundaryHoldsFarFromTheOrigin) {
  const glm::dvec2 far(5.8e6, 3.4e5);
  Space space;
  space.shell =
      RoomShell{{far, far + glm::dvec2(3, 0), far + glm::dvec2(3, 4.1), far + glm::dvec2(0, 4.1)},
                812.3,
                2.5};
  CalcPlane wall = plane_of(rectangle(4.1, 2.5), GridByCount{7, 5});
  area_of(wall).origin_m = {far.x + 3, far.y, 812.3};
  area_of(wall).u = {0, 1, 0};
  area_of(wall).v = {0, 0, 1};
  const Made made = make(wall, space);
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->position_m.size(), 35u);
}

TEST(SensorGrid, PointsInClosedBodiesAreDroppedByName) {
  Space space;
  space.bodies = {box("lamp", {9, 9, 0}, {10, 10, 3}), box("pillar", {1, 1, 0}, {2, 2, 3})};
  const Made made = make(plane_of(rectangle(4, 4), GridByCount{4, 4}), space);
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->position_m.size(), 15u);
  ASSERT_EQ(made.grid->dropped.size(), 1u);
  EXPECT_EQ(made.grid->dropped[0].reason, DropReason::inside_solid);
  EXPECT_EQ(made.grid->dropped[0].body, "pillar");
  EXPECT_EQ(made.grid->dropped[0].column, 1);
  EXPECT_EQ(made.grid->dropped[0].row, 1);
  EXPECT_EQ(made.grid->dropped[0].position_m, glm::dvec3(1.5, 1.5, 0.75));
  space.bodies[1].is_closed = false;
  EXPECT_EQ(make(plane_of(rectangle(4, 4), GridByCount{4, 4}), space).grid->position_m.size(), 16u);
}

TEST(SensorGrid, APlaneOnTopOfABoxIsKeptAndOneLookingIntoItIsNot) {
  Space space;
  space.bodies = {box("table", {-1, -1, 0}, {5, 3, 0.75})};
  CalcPlane top = plane_of(rectangle(4, 2), GridByRule{}, 0.75);
  const Made on_top = make(top, space);
  ASSERT_TRUE(on_top.grid);
  EXPECT_TRUE(on_top.grid->dropped.empty());
  std::swap(area_of(top).u, area_of(top).v);
  area_of(top).outline_m = rectangle(2, 4);
  EXPECT_FALSE(make(top, space).grid) << "its normal points down, into the table";
  EXPECT_FALSE(make(plane_of(rectangle(4, 2), GridByRule{}, 0.749), space).grid) << "inside";
}

TEST(SensorGrid, TheAxisIsTheNormalOrTheDirectionLookedIn) {
  CalcPlane plane = plane_of(rectangle(2, 2), GridByCount{1, 1});
  plane.kernel = ReceiverKernel::cylindrical;
  const Made cylinder = make(plane);
  ASSERT_TRUE(cylinder.grid);
  EXPECT_EQ(cylinder.grid->kernel, ReceiverKernel::cylindrical);
  EXPECT_EQ(cylinder.grid->normal[0], glm::dvec3(0, 0, 1));
  plane.kernel = ReceiverKernel::semicylindrical;
  plane.direction = {0.6, 0.8, 0};
  const Made half = make(plane);
  ASSERT_TRUE(half.grid);
  EXPECT_EQ(half.grid->kernel, ReceiverKernel::semicylindrical);
  EXPECT_EQ(half.grid->normal[0], glm::dvec3(0.6, 0.8, 0));
}

TEST(SensorGrid, TheSideOfASurfaceIsThePlanesWhateverTheAxis) {
  Space space;
  space.bodies = {box("table", {-1, -1, 0}, {5, 3, 0.75})};
  CalcPlane plane = plane_of(rectangle(4, 2), GridByRule{}, 0.75);
  plane.kernel = ReceiverKernel::semicylindrical;
  plane.direction = {1, 0, 0};
  const Made on_top = make(plane, space);
  ASSERT_TRUE(on_top.grid);
  EXPECT_TRUE(on_top.grid->dropped.empty());
  std::swap(area_of(plane).u, area_of(plane).v);
  area_of(plane).outline_m = rectangle(2, 4);
  EXPECT_FALSE(make(plane, space).grid) << "looks along the table top, from below";
}

TEST(SensorGrid, APointInTheSideOfABodyIsMeasuredBesideIt) {
  Space space;
  space.bodies = {box("cupboard", {-1, -1, 0}, {1.5, 5, 3})};
  CalcPlane plane = plane_of(rectangle(4, 4), GridByCount{4, 4});  // x = 0.5, 1.5, 2.5, 3.5
  for (const ReceiverKernel kernel : {ReceiverKernel::planar, ReceiverKernel::cylindrical,
                                      ReceiverKernel::hemispherical, ReceiverKernel::scalar}) {
    plane.kernel = kernel;
    const Made made = make(plane, space);
    ASSERT_TRUE(made.grid);
    EXPECT_EQ(dropped_for(*made.grid, DropReason::inside_solid), 4u);
    ASSERT_EQ(made.grid->inner.size(), 4u);
    for (const InnerPoint& inner : made.grid->inner) {
      EXPECT_EQ(made.grid->position_m[inner.point].x, 1.5);
      EXPECT_GT(made.grid->measured_m(inner.point).x, 1.5);
      EXPECT_LT(made.grid->measured_m(inner.point).x, 1.5002);
      EXPECT_EQ(inner.body, "cupboard");
    }
    EXPECT_TRUE(made.messages.empty()) << "said with the results";
  }
  PointList list;
  list.position_m = {{1.5, 0.5, 0.75}, {3, 3, 0.75}};
  list.normal = {{0, 0, 1}, {0, 0, 1}};
  plane.kernel = ReceiverKernel::planar;
  plane.area = list;
  EXPECT_EQ(make(plane, space).messages,
            std::vector<std::string>{
                "project.xml:7:3: warning[points-beside-surface]: plane 'desk': 1 of 2 points are "
                "in a surface that crosses the plane and are measured just beside it, on the side "
                "with air; the first is at (1.5, 0.5, 0.75) m, in 'cupboard'"});
}

TEST(SensorGrid, PointsInAScreenAreLeftOutAndSaid) {
  Space space;
  Body screen = box("screen", {1.5, -1, 0}, {1.5, 5, 3});
  screen.is_closed = false;
  screen.triangle = {{0, 2, 6}, {0, 6, 4}};
  space.bodies = {screen};
  const Made made = make(plane_of(rectangle(4, 4), GridByCount{4, 4}), space);
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->position_m.size(), 12u);
  ASSERT_EQ(dropped_for(*made.grid, DropReason::in_surface), 4u);
  EXPECT_EQ(made.grid->dropped[0].body, "screen");
  ASSERT_EQ(made.messages.size(), 1u);
  EXPECT_EQ(made.messages[0],
            "project.xml:7:3: warning[points-in-surface]: plane 'desk': 4 of 16 points are left "
            "out; they are in a surface with air on both sides, or where surfaces leave no space; "
            "the light differs from side to side; the first is at (1.5, 0.5, 0.75) m, in 'screen'; "
            "move the points, or give the surface a thickness");
}

TEST(SensorGrid, APlaneThatKeepsNoPointIsAnErrorWithTheCounts) {
  Space space;
  space.shell = RoomShell{rectangle(2, 4), 0.0, 3.0};
  space.bodies = {box("table", {-1, -1, 0}, {5, 5, 1})};
  CalcPlane plane = plane_of(rectangle(4, 4), GridByCount{4, 4});
  area_of(plane).holes_m = {{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}}};
  EXPECT_EQ(make(plane, space).messages,
            std::vector<std::string>{
                "project.xml:7:3: error[grid-without-points]: plane 'desk' cannot be judged: "
                "none of the 16 points is left: 1 outside the area, 0 in the margin, 8 outside "
                "the room, 7 inside solids, 0 in surfaces"});
}

TEST(SensorGrid, MoreThanFourMillionPointsAreAnError) {
  EXPECT_EQ(make(plane_of(rectangle(4, 4), GridByCount{2001, 2000})).messages,
            std::vector<std::string>{
                "project.xml:7:3: error[grid-too-many-points]: plane 'desk' cannot be judged: "
                "the grid would have 2001 x 2000 points; at most 4000000 points are allowed"});
  EXPECT_FALSE(make(plane_of(rectangle(4, 4), GridBySpacing{1e-300, 1e-300, {}})).grid);
  EXPECT_FALSE(make(plane_of(rectangle(4, 4), GridBySpacing{0.0, 1.0, {}})).grid);
  EXPECT_FALSE(make(plane_of(rectangle(1e9, 1e-9), GridByRule{})).grid);
}

TEST(SensorGrid, CellsThatAreTooLongAreWarnedOf) {
  CalcPlane plane = plane_of(rectangle(4.0, 1.0001), GridByRule{});
  area_of(plane).margin_m = 0.5;  // a strip of 0.1 mm is left: p = 0.32 mm
  EXPECT_EQ(make(plane).messages,
            std::vector<std::string>{
                "project.xml:7:3: warning[grid-cell-shape]: plane 'desk': cells are 0.00032 m x "
                "0.0001 m; EN 12464-1 asks for sides in a ratio of 0.5 to 2"});
  area_of(plane).grid = GridByCount{100, 1};
  EXPECT_TRUE(make(plane).messages.empty()) << "asked for by number";
}

TEST(SensorGrid, PointListsAreTakenAsGivenAndFilteredAlike) {
  Space space;
  space.shell = RoomShell{rectangle(4, 4), 0.0, 3.0};
  space.bodies = {box("pillar", {1, 1, 0}, {2, 2, 3})};
  PointList list;
  list.position_m = {{0.5, 0.5, 1}, {1.5, 1.5, 1}, {5, 1, 1}, {2, 1.5, 1}, {2, 1.5, 1}};
  list.normal = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}};
  CalcPlane plane = plane_of({}, GridByRule{});
  plane.area = list;
  const Made made = make(plane, space);
  ASSERT_TRUE(made.grid);
  EXPECT_EQ(made.grid->rule, "point list");
  EXPECT_EQ(made.grid->columns, 0);
  EXPECT_EQ(made.grid->position_m, (std::vector<glm::dvec3>{{0.5, 0.5, 1}, {2, 1.5, 1}}));
  EXPECT_EQ(made.grid->normal[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(made.grid->column, (std::vector<int>{0, 3})) << "place in the list";
  EXPECT_EQ(dropped_for(*made.grid, DropReason::inside_solid), 2u);
  EXPECT_EQ(dropped_for(*made.grid, DropReason::outside_room), 1u);
}

}  // namespace
}  // namespace calc::sensor_grid_test
