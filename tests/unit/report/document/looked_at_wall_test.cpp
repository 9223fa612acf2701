#include "report/document/looked_at_wall.h"

#include <gtest/gtest.h>

#include <vector>

namespace report::looked_at_wall_test {
namespace {

SpacePart l_shaped() {
  SpacePart space;
  // An L whose second edge is in line with the first: walls 1 and 2 are one.
  space.footprint_m = {{0, 0}, {4, 0}, {8, 0}, {8, 3}, {4, 3}, {4, 6}, {0, 6}};
  return space;
}

PlanePart observers(const std::vector<glm::dvec2>& places, const glm::dvec3& look) {
  PlanePart plane;
  plane.derived = calc::DerivedQuantity::ugr;
  for (const glm::dvec2& place : places) {
    PointRow point;
    point.position_m = glm::dvec3(place, 1.2);
    point.normal = look;
    plane.points.push_back(point);
  }
  return plane;
}

TEST(LookedAtWall, IsTheFirstOneAhead) {
  const SpacePart space = l_shaped();
  EXPECT_EQ(looked_at_wall(space, observers({{1, 1}}, {1, 0, 0})), 3U);
  EXPECT_EQ(looked_at_wall(space, observers({{1, 4}}, {1, 0, 0})), 5U);
  EXPECT_EQ(looked_at_wall(space, observers({{1, 1}}, {-1, 0, 0})), 7U);
  SpacePart u_shaped;  // behind the wall ahead there are two more
  u_shaped.footprint_m = {{0, 0}, {9, 0}, {9, 5}, {6, 5}, {6, 2}, {3, 2}, {3, 5}, {0, 5}};
  EXPECT_EQ(looked_at_wall(u_shaped, observers({{8, 4}}, {-1, 0, 0})), 4U);
}

TEST(LookedAtWall, IsTheOneOfMostPoints) {
  EXPECT_EQ(looked_at_wall(l_shaped(), observers({{1, 4}, {1, 1}, {2, 1}}, {1, 0, 0})), 3U);
}

TEST(LookedAtWall, HasTheNumberOfTheFirstInItsLine) {
  EXPECT_EQ(looked_at_wall(l_shaped(), observers({{6, 1}}, {0, -1, 0})), 1U);
}

TEST(LookedAtWall, IsNoneWhereNothingIsLookedAt) {
  const SpacePart space = l_shaped();
  EXPECT_EQ(looked_at_wall(SpacePart{}, observers({{1, 1}}, {1, 0, 0})), 0U);  // in the open
  EXPECT_EQ(looked_at_wall(space, observers({}, {1, 0, 0})), 0U);
  EXPECT_EQ(looked_at_wall(space, observers({{-1, 1}}, {-1, 0, 0})), 0U);  // away from the room
  PlanePart wall = observers({{1, 1}}, {1, 0, 0});
  wall.derived = calc::DerivedQuantity::none;
  EXPECT_EQ(looked_at_wall(space, wall), 0U);
}

}  // namespace
}  // namespace report::looked_at_wall_test
