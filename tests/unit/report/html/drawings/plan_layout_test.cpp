#include "report/html/drawings/plan_layout.h"

#include "report/text/point_thresholds.h"
#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

namespace report::plan_layout_test {
namespace {

TEST(PlanLayout, ShowsTheRoomInThePlanesCoordinates) {
  const Document document = small_document();
  const SpacePart& space = document.projects[0].spaces[0];
  const PlanLayout layout = lay_out_plan(space, space.planes[0], {640, 460});
  ASSERT_EQ(layout.room_m.size(), 4U);
  EXPECT_NEAR(layout.room_m[0].x, -0.5, 1e-12);  // the grid starts at (0.5, 0.25)
  EXPECT_NEAR(layout.room_m[0].y, -0.25, 1e-12);
  EXPECT_LE(layout.width_px(), 640 + 1e-9);
  EXPECT_LE(layout.height_px(), 460 + 1e-9);
  EXPECT_GT(layout.pixel({0, 0}).y, layout.pixel({0, 1}).y);  // v is up
}

TEST(PlanLayout, SmallPlaneInALargeRoomIsNotLost) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.footprint_m = {{0, 0}, {100, 0}, {100, 80}, {0, 80}};
  space.luminaires = {{{90, 70, 5}, "far"}, {{2, 1, 5}, "near"}};
  const PlanLayout layout = lay_out_plan(space, space.planes[0], {640, 460});
  EXPECT_LT(layout.high_m.x - layout.low_m.x, 5);
  EXPECT_EQ(layout.luminaires_m.size(), 1U);
}

TEST(PlanLayout, VerticalPlaneShowsNoRoom) {
  const Document document = sample_document();
  const SpacePart& space = document.projects[0].spaces[0];
  const PlanLayout layout = lay_out_plan(space, space.planes[1], {640, 460});
  EXPECT_TRUE(layout.room_m.empty());
  EXPECT_TRUE(layout.luminaires_m.empty());
}

// The drawing against the geometry, on a grid that is turned and seen from below: whatever lies at
// origin + a u + b v in the world is drawn at (a, b).
TEST(PlanLayout, FurnitureAndLuminairesLieWhereTheyAreInTheWorld) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  PlanePart& plane = space.planes[0];
  plane.grid.u = {0.8, 0.6, 0};
  plane.grid.v = {0.6, -0.8, 0};  // u x v points down
  plane.grid.origin_m = {1, 1, 0.8};
  const auto world = [&](double a, double b) {
    return plane.grid.origin_m + a * plane.grid.u + b * plane.grid.v;
  };
  LuminaireMark mark{world(1.0, 0.5), "panel"};
  mark.outline_m = {glm::dvec2(world(0.9, 0.4)), glm::dvec2(world(1.1, 0.4)),
                    glm::dvec2(world(1.1, 0.6))};
  mark.c0 = plane.grid.v;
  space.luminaires = {mark};
  space.bodies = {{"desk", 0, 0.75, {{glm::dvec2(world(0.2, 0.1)), glm::dvec2(world(2.2, 0.1))}}},
                  {"beam", 2, 2.2, {{glm::dvec2(world(0, 1)), glm::dvec2(world(3, 1))}}},
                  {"far", 0, 1, {{glm::dvec2(90, 90), glm::dvec2(91, 90)}}}};
  const PlanLayout layout = lay_out_plan(space, plane, {640, 460});
  ASSERT_EQ(layout.luminaires_m.size(), 1U);
  const PlanLuminaire& sign = layout.luminaires_m[0];
  EXPECT_NEAR(glm::distance(sign.place_m, {1.0, 0.5}), 0, 1e-12);
  EXPECT_NEAR(glm::distance(sign.outline_m.at(2), {1.1, 0.6}), 0, 1e-12);
  EXPECT_NEAR(glm::distance(sign.c0, {0, 1}), 0, 1e-12);
  ASSERT_EQ(layout.furniture_m.size(), 2U);  // the far one is not in the picture
  EXPECT_NEAR(glm::distance(layout.furniture_m[0].to_m, {2.2, 0.1}), 0, 1e-12);
  EXPECT_FALSE(layout.furniture_m[0].is_above);
  EXPECT_TRUE(layout.furniture_m[1].is_above);
  // v is up in the drawing, so C0 is, too.
  EXPECT_LT(layout.pixel(sign.place_m + sign.c0).y, layout.pixel(sign.place_m).y);
}

TEST(PlanLimits, OnlyThoseThatTheDrawnPointsMustMeet) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  rules::Finding initial = plane.findings[1];
  initial.requirement.state = rules::LightState::initial;
  initial.requirement.limit = 700;
  plane.findings.push_back(initial);
  ASSERT_EQ(plan_limits({}, plane).size(), 2U);
  EXPECT_EQ(plan_limits({}, plane)[0].words, "average ≥ 500 lx");
  EXPECT_EQ(point_threshold(plane, PointSide::from_below)->limit, 450);
  EXPECT_FALSE(point_threshold(plane, PointSide::from_above));
}

// Results as files know a mask's name only, not its operations.
TEST(PlanLimits, MaskedOnesAreOfOtherPoints) {
  for (const bool has_operations : {false, true}) {
    PlanePart plane = small_document().projects[0].spaces[0].planes[0];
    for (rules::Finding& finding : plane.findings) {
      finding.requirement.mask.id = "inner";
      if (has_operations)
        finding.requirement.mask.operations = {{rules::MaskStep::inset, 0.5, 0, 0}};
    }
    EXPECT_TRUE(plan_limits({}, plane).empty());
    EXPECT_FALSE(point_threshold(plane, PointSide::from_below));
  }
}

TEST(PlanLimits, StrictOnesCountAsTheirSides) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  rules::Finding strict = plane.findings[1];
  strict.requirement.comparison = rules::Comparison::more_than;
  plane.findings.push_back(strict);
  EXPECT_EQ(point_threshold(plane, PointSide::from_below)->comparison,
            rules::Comparison::more_than);
  EXPECT_TRUE(misses(point_threshold(plane, PointSide::from_below), 450));
  strict.requirement.metric = rules::Metric::maximum;
  strict.requirement.comparison = rules::Comparison::less_than;
  plane.findings.push_back(strict);
  EXPECT_TRUE(misses(point_threshold(plane, PointSide::from_above), 450));
  EXPECT_FALSE(misses(point_threshold(plane, PointSide::from_above), 449));
  EXPECT_EQ(point_thresholds(plane).list.size(), 2U);
}

TEST(ScaleBar, IsRoundAndAtMostAThird) {
  EXPECT_DOUBLE_EQ(scale_bar_m(9.4), 2.0);
  EXPECT_DOUBLE_EQ(scale_bar_m(46), 10.0);
  EXPECT_DOUBLE_EQ(scale_bar_m(2.6), 0.5);
}

// A route is as large as its outline, not as its cells in a row.
TEST(PlanLayout, OfARouteIsAroundItsOutline) {
  Document document = route_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.footprint_m.clear();
  const PlanLayout layout = lay_out_plan(space, space.planes[0], {640, 460});
  const double width_m = layout.high_m.x - layout.low_m.x;
  EXPECT_GT(width_m, 4.6);
  EXPECT_LT(width_m, 6.0);
}

}  // namespace
}  // namespace report::plan_layout_test
