// Grids of escape routes: where their points lie, and why some are left out.

#include "calc/scene/sensor_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace calc::route_grid_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CalcPlane route_of(std::vector<glm::dvec3> corner_m, double width_m, double height_m = 0.0) {
  EscapeRoute route;
  route.line = {std::move(corner_m), width_m};
  route.height_m = height_m;
  route.spacing.along_u_m = route.spacing.along_v_m = kRouteSpacing_m;
  CalcPlane plane;
  plane.id = "out";
  plane.where = {"project.xml", 7, 3};
  plane.area = route;
  return plane;
}

void set_spacing(CalcPlane& plane, double along_m, double across_m) {
  auto& route = std::get<EscapeRoute>(plane.area);
  route.spacing = {along_m, across_m, {}};
  route.is_spacing_given = true;
}

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

Body quad(const std::string& id, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  Body body;
  body.id = id;
  body.vertex_m = {a, b, c, d};
  body.triangle = {{0, 1, 2}, {0, 2, 3}};
  return body;
}

struct Made {
  std::optional<SensorGrid> grid;
  std::string messages;
};

Made make(const CalcPlane& plane, const Space& space = {}) {
  Diagnostics diagnostics;
  Made made;
  made.grid = make_sensor_grid(plane, space, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) made.messages += format_diagnostic(d);
  EXPECT_EQ(made.grid.has_value(), !diagnostics.has_errors());
  return made;
}

// A room without a floor of its own, but what is put there: no ground is assumed in it.
Space indoors(std::vector<Body> bodies) {
  Space space;
  space.surfaces_file = "building.xml";
  space.bodies = std::move(bodies);
  return space;
}

Space room(double x_m, double y_m) {
  Space space;
  space.shell = RoomShell{{{0, 0}, {x_m, 0}, {x_m, y_m}, {0, y_m}}, 0.0, 3.0};
  space.bodies = {quad("r.floor", {0, 0, 0}, {x_m, 0, 0}, {x_m, y_m, 0}, {0, y_m, 0}),
                  quad("r.ceiling", {0, 0, 3}, {x_m, 0, 3}, {x_m, y_m, 3}, {0, y_m, 3})};
  return space;
}

std::vector<std::string> bodies_of(const SensorGrid& grid, DropReason reason) {
  std::set<std::string> names;
  for (const DroppedPoint& point : grid.dropped) {
    if (point.reason == reason) names.insert(point.body);
  }
  return {names.begin(), names.end()};
}

std::size_t dropped_for(const SensorGrid& grid, DropReason reason) {
  return static_cast<std::size_t>(
      std::count_if(grid.dropped.begin(), grid.dropped.end(),
                    [&](const DroppedPoint& point) { return point.reason == reason; }));
}

TEST(RouteGrid, HasAnOddNumberOfRowsAndFiveAtLeast) {
  const auto rows = [](double width_m) {
    return make(route_of({{0, 0, 0}, {4, 0, 0}}, width_m)).grid->rows;
  };
  EXPECT_EQ(rows(1.0), 5);
  EXPECT_EQ(rows(2.5), 5);
  EXPECT_EQ(rows(2.6), 7);
  EXPECT_EQ(rows(3.5), 7);
  CalcPlane coarse = route_of({{0, 0, 0}, {4, 0, 0}}, 1.5);
  set_spacing(coarse, 1.0, 1.0);
  EXPECT_EQ(make(coarse).grid->rows, 3);
  set_spacing(coarse, 1.0, 2.0);
  EXPECT_EQ(make(coarse).grid->rows, 1);
}

TEST(RouteGrid, LiesOnTheGroundInTheOpen) {
  const Made made = make(route_of({{1, 0, 0.1}, {4, 0, 0.2}}, 1.5, 0.02));
  EXPECT_EQ(made.messages, "");
  EXPECT_EQ(made.grid->columns, 6);
  EXPECT_DOUBLE_EQ(made.grid->route->height_m, 0.02);
  EXPECT_EQ(made.grid->position_m.size(), 30u);
  for (const glm::dvec3& point : made.grid->position_m) EXPECT_DOUBLE_EQ(point.z, 0.02);
  for (const glm::dvec3& normal : made.grid->normal) EXPECT_EQ(normal, glm::dvec3(0, 0, 1));
}

// The ground is assumed only where nothing is below: here it would be 0.4 m above the pit's floor.
TEST(RouteGrid, AssumesNoGroundAboveWhatIsThere) {
  Space pit;
  pit.bodies = {quad("pit", {0, -2, -0.4}, {9, -2, -0.4}, {9, 2, -0.4}, {0, 2, -0.4})};
  const Made made = make(route_of({{1, 0, -0.3}, {4, 0, -0.3}}, 1.5), pit);
  for (const glm::dvec3& point : made.grid->position_m) EXPECT_DOUBLE_EQ(point.z, -0.4);
}

TEST(RouteGrid, StandsOnTheTreadsOfAStair) {
  Space space;
  for (int i = 1; i <= 5; ++i) {
    space.bodies.push_back(
        box("tread" + std::to_string(i), {1.0 + 0.3 * i, -1, 0}, {1.3 + 0.3 * i, 1, 0.18 * i}));
  }
  CalcPlane stair = route_of({{1.3, 0, 0}, {2.8, 0, 0.9}}, 1.2, 0.01);
  set_spacing(stair, 0.3, 0.4);
  const Made made = make(stair, space);
  EXPECT_EQ(made.messages, "");
  ASSERT_EQ(made.grid->position_m.size(), 15u);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_NEAR(made.grid->position_m[i].z, 0.18 * (made.grid->column[i] + 1) + 0.01, 1e-12);
  }
}

// z = 0.2 x, met exactly, also on the diagonal of its two triangles.
TEST(RouteGrid, FollowsARamp) {
  const Space ramp = indoors({quad("ramp", {0, -2, 0}, {4, -2, 0.8}, {4, 2, 0.8}, {0, 2, 0})});
  const Made made = make(route_of({{0, 0, 0}, {4, 0, 0.8}}, 2.0), ramp);
  EXPECT_EQ(made.messages, "");
  EXPECT_EQ(made.grid->position_m.size(), 8u * 5u);
  for (const glm::dvec3& p : made.grid->position_m) EXPECT_NEAR(p.z, 0.2 * p.x, 1e-12);
}

TEST(RouteGrid, LeavesOutWhatStandsInTheWayAndNamesIt) {
  Space space = room(10, 4);
  space.bodies.push_back(box("table", {2, 1, 0}, {3, 3, 0.72}));
  space.bodies.push_back(box("cupboard", {4, 1, 0}, {5, 3, 2.0}));
  space.bodies.push_back(quad("board", {6, 1, 0.7}, {7, 1, 0.7}, {7, 3, 0.7}, {6, 3, 0.7}));
  space.bodies.push_back(quad("lintel", {8, 1, 2.1}, {9, 1, 2.1}, {9, 3, 2.1}, {8, 3, 2.1}));
  const Made made = make(route_of({{0, 2, 0}, {10, 2, 0}}, 1.0), space);
  EXPECT_EQ(made.messages, "");
  EXPECT_THAT(bodies_of(*made.grid, DropReason::in_the_way), ElementsAre("board", "table"));
  EXPECT_EQ(dropped_for(*made.grid, DropReason::in_the_way), 2u * 2u * 5u);
  EXPECT_THAT(bodies_of(*made.grid, DropReason::inside_solid), ElementsAre("cupboard"));
  for (const glm::dvec3& point : made.grid->position_m) EXPECT_EQ(point.z, 0.0);
}

// 0.3 m is a step, what is higher is not.
TEST(RouteGrid, StepsUpAndDownSoFar) {
  const auto kept = [](double z_m) {
    const Space space = indoors({quad("s", {0, -2, z_m}, {4, -2, z_m}, {4, 2, z_m}, {0, 2, z_m})});
    Diagnostics diagnostics;
    return make_sensor_grid(route_of({{0, 0, 5}, {4, 0, 5}}, 1.0), space, diagnostics).has_value();
  };
  EXPECT_TRUE(kept(5.3));
  EXPECT_FALSE(kept(5.301));
  EXPECT_TRUE(kept(4.5));
  EXPECT_FALSE(kept(4.499));
}

TEST(RouteGrid, WarnsOfAHoleInTheFloor) {
  const Space space = indoors({quad("a", {0, -2, 0}, {2, -2, 0}, {2, 2, 0}, {0, 2, 0}),
                               quad("b", {3, -2, 0}, {9, -2, 0}, {9, 2, 0}, {3, 2, 0})});
  const Made made = make(route_of({{0, 0, 0}, {9, 0, 0}}, 1.0), space);
  EXPECT_EQ(made.messages,
            "project.xml:7:3: warning[route-points-left-out]: route 'out': 10 of 90 points are "
            "left out: 10 have no surface to walk on between 0.5 m below and 0.3 m above its line, "
            "0 are outside the room; the first is at (2.25, -0.4, 0) m");
  EXPECT_EQ(dropped_for(*made.grid, DropReason::without_floor), 10u);
}

TEST(RouteGrid, WithoutAnyFloorIsAnErrorThatSaysWhere) {
  const Made made = make(route_of({{1, 2, 1}, {5, 2, 1}}, 1.0), room(10, 4));
  EXPECT_EQ(made.messages,
            "project.xml:7:3: error[route-without-points]: route 'out' cannot be judged: none of "
            "the 40 points is left: 40 without a floor from 0.5 m below to 0.3 m above the "
            "route, 0 at obstacles, 0 inside solids, 0 outside the room. The first is at (1.25, "
            "1.6, 1) m. Set the heights of 'points' to the floor");
}

TEST(RouteGrid, LeavesOutWhatIsBeyondTheWalls) {
  const Made made = make(route_of({{1, 2, 0}, {12, 2, 0}}, 1.0), room(10, 4));
  EXPECT_EQ(dropped_for(*made.grid, DropReason::outside_room), 4u * 5u);
  EXPECT_EQ(dropped_for(*made.grid, DropReason::without_floor), 0u);
  EXPECT_THAT(made.messages, HasSubstr("20 are outside the room"));
}

TEST(RouteGrid, TooManyPointsAreAnError) {
  CalcPlane fine = route_of({{0, 0, 0}, {1000, 0, 0}}, 2.0);
  set_spacing(fine, 0.01, 0.01);
  EXPECT_THAT(make(fine).messages, HasSubstr("error[grid-too-many-points]"));
}

TEST(RouteGrid, PointsCountByTheAreaOfTheirCells) {
  EXPECT_TRUE(point_weights(*make(route_of({{0, 0, 0}, {4, 0, 0}}, 1.5)).grid).empty());
  const Made bent = make(route_of({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, 1.5));
  const std::vector<double> weights = point_weights(*bent.grid);
  ASSERT_EQ(weights.size(), bent.grid->position_m.size());
  double sum_m2 = 0.0;
  for (const double weight : weights) sum_m2 += weight;
  EXPECT_NEAR(sum_m2, 7.0 * 1.5, 1e-9);
}

}  // namespace
}  // namespace calc::route_grid_test
