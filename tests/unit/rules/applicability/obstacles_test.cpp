#include "rules/applicability/obstacles.h"

#include <gtest/gtest.h>

namespace rules::obstacles_test {
namespace {

calc::Body box_to(const char* id, double top_m) {
  calc::Body body;
  body.id = id;
  for (int i = 0; i < 8; ++i) {
    body.vertex_m.emplace_back(i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? top_m : 0.0);
  }
  body.triangle = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return body;
}

// A rack is one, a table top that somebody has drawn too high is none.
TEST(PointsInObstacles, AreThoseInBodiesThatReachHalfAMetreAboveThem) {
  calc::Space space;
  space.bodies = {box_to("table", 1.2), box_to("rack", 2.0)};
  calc::SensorGrid grid;
  const auto drop = [&](calc::DropReason reason, const char* body) {
    grid.dropped.push_back({glm::dvec3(0.4, 0.3, 0.75), 0, 0, reason, body});
  };
  drop(calc::DropReason::inside_solid, "table");
  EXPECT_EQ(points_in_obstacles(grid, space), 0u);
  drop(calc::DropReason::inside_solid, "rack");
  drop(calc::DropReason::inside_solid, "no such body");
  drop(calc::DropReason::outside_room, "rack");
  EXPECT_EQ(points_in_obstacles(grid, space), 1u);
}

}  // namespace
}  // namespace rules::obstacles_test
