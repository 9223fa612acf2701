// Which rooms share a floor plan.
#include "report/document/storeys.h"

#include "report/document/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace report::storeys_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

SpacePart room(double x, double y, double z, double width = 4.0, double depth = 3.0) {
  SpacePart space;
  space.footprint_m = {{x, y}, {x + width, y}, {x + width, y + depth}, {x, y + depth}};
  space.floor_z_m = z;
  space.height_m = 2.8;
  return space;
}

ProjectPart project(std::vector<SpacePart> spaces) {
  ProjectPart part;
  part.spaces = std::move(spaces);
  return part;
}

std::vector<std::vector<std::size_t>> rooms_of(const Storeys& storeys) {
  std::vector<std::vector<std::size_t>> rooms;
  for (const Storey& storey : storeys.list) rooms.push_back(storey.rooms);
  return rooms;
}

TEST(Storeys, AreByTheHeightOfFloors) {
  // Upstairs first; floors of a storey differ by 2 cm, and by a step of 0.6 m.
  const Storeys storeys = storeys_of(project(
      {room(0, 0, 3.12), room(4, 0, 0.02), room(0, 0, 0.0), room(8, 0, 0.6), room(4, 0, 3.10)}));
  EXPECT_THAT(rooms_of(storeys), ElementsAre(ElementsAre(1, 2, 3), ElementsAre(0, 4)));
  EXPECT_EQ(storeys.list[0].floor_z_m, 0.0);
  EXPECT_EQ(storeys.list[1].floor_z_m, 3.10);
  EXPECT_THAT(storeys.overlapping, IsEmpty());
}

TEST(Storeys, HalfALevelIsAStorey) {
  const Storeys storeys =
      storeys_of(project({room(0, 0, 0.0), room(4, 0, 1.4), room(0, 4, 0.0), room(4, 4, 1.4)}));
  EXPECT_THAT(rooms_of(storeys), ElementsAre(ElementsAre(0, 2), ElementsAre(1, 3)));
}

// A room in the corner of an L-shaped one lies in its box and not over it.
TEST(Storeys, RoomsOverlapByTheirOutlines) {
  SpacePart corner = room(0, 0, 0, 10, 10);
  corner.footprint_m = {{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}};
  EXPECT_FALSE(overlap_in_plan(corner, room(4, 4, 0)));
  EXPECT_TRUE(overlap_in_plan(corner, room(0, 0, 3)));
  EXPECT_TRUE(overlap_in_plan(room(0, 0, 3), corner));
  EXPECT_FALSE(overlap_in_plan(corner, SpacePart()));
}

TEST(Storeys, WallsMayOverlapALittle) {
  const Storeys storeys = storeys_of(project({room(0, 0, 0), room(3.7, 0, 0)}));
  EXPECT_THAT(rooms_of(storeys), ElementsAre(ElementsAre(0, 1)));
}

TEST(Storeys, ARoomOverAnotherIsOnNoPlan) {
  const Storeys storeys =
      storeys_of(project({room(0, 0, 0), room(5, 0, 0), room(1, 0.5, 0.1, 1, 1)}));
  EXPECT_THAT(rooms_of(storeys), ElementsAre(ElementsAre(0, 1)));
  EXPECT_THAT(storeys.overlapping, ElementsAre(2));
}

TEST(Storeys, RoomsAroundOriginsOfTheirOwnAreOnNoPlan) {
  std::vector<SpacePart> rooms;
  for (int i = 0; i < 30; ++i) rooms.push_back(room(0, 0, 0, 4 + 0.1 * i));
  const Storeys storeys = storeys_of(project(rooms));
  EXPECT_THAT(storeys.list, IsEmpty());
  EXPECT_EQ(storeys.overlapping.size(), 30U);
}

TEST(Storeys, AlternativesOfAStoreyHavePlansOfTheirOwn) {
  const Storeys storeys =
      storeys_of(project({room(0, 0, 0), room(5, 0, 0), room(0, 0, 0), room(5, 0, 0)}));
  EXPECT_THAT(rooms_of(storeys), ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
}

TEST(Storeys, TellRoomsWithoutOutlineFromOutdoors) {
  SpacePart street, mesh, broken = room(0, 0, 0), far = room(0, 0, 0), floating = room(0, 0, 0),
                          endless = room(0, 0, 0);
  mesh.surface_lines_m = {{0, 0, 0}, {1, 0, 0}};
  broken.footprint_m[1].x = std::numeric_limits<double>::quiet_NaN();
  far.footprint_m[2].y = 1e300;
  floating.floor_z_m = std::numeric_limits<double>::infinity();
  endless.footprint_m.resize(kMostPlanCorners + 1);
  const Storeys storeys =
      storeys_of(project({street, mesh, broken, far, floating, endless, room(0, 0, 0)}));
  EXPECT_THAT(storeys.outdoors, ElementsAre(0));
  EXPECT_THAT(storeys.without_outline, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(rooms_of(storeys), ElementsAre(ElementsAre(6)));
}

}  // namespace
}  // namespace report::storeys_test
