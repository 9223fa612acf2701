#include "calc/radiosity/looks/cutaway.h"

#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace cutaway_test {
namespace {

using namespace test_support;

struct Room {
  calc::PreparedScene scene;
  // Quads in order: room floor, ceiling, y low, y high, x low, x high, then those of a desk.
  Room() {
    add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.5);
    add_box(scene, {1, 1, 0.4}, {1, 1, 0.3}, 0.5);
    set_extent(scene);
  }
};

TEST(Cutaway, OpensARoomTowardsTheEye) {
  const Room room;
  const calc::Tracer tracer(room.scene);
  const glm::dvec3 eye(-6, -9, 9);
  const calc::Cutaway cut = calc::cut_away(tracer, eye, true);
  EXPECT_EQ(std::set<std::uint32_t>(cut.removed.begin(), cut.removed.end()),
            (std::set<std::uint32_t>{2, 3, 4, 5, 8, 9}));  // ceiling, y low, x low
  EXPECT_EQ(cut.shown.size(), room.scene.triangle.size() - 6);
  for (const calc::SurfaceSide& side : cut.shown) {
    const glm::uvec3& t = room.scene.triangle[side.triangle];
    const glm::dvec3 a(room.scene.vertex_m[t.x]), b(room.scene.vertex_m[t.y]),
        c(room.scene.vertex_m[t.z]);
    EXPECT_GE(glm::dot(glm::dvec3(side.normal), eye - a), 0.0);
    const double turn = glm::dot(glm::cross(b - a, c - a), glm::dvec3(side.normal));
    EXPECT_EQ(turn < 0.0, side.is_flipped);
  }
}

TEST(Cutaway, LeavesOpenSpaceAlone) {
  const Room room;
  const calc::Tracer tracer(room.scene);
  const calc::Cutaway cut = calc::cut_away(tracer, {-6, -9, 9}, false);
  EXPECT_TRUE(cut.removed.empty());
  EXPECT_EQ(cut.shown.size(), room.scene.triangle.size());
}

// The inside of the room from every eye, and the desk from all sides.
TEST(Cutaway, KeepsWhatModelsAreSeenFrom) {
  const Room room;
  const calc::Tracer tracer(room.scene);
  const std::vector<calc::SurfaceSide> all = calc::sides_from_everywhere(tracer, true);
  std::size_t of_room = 0;
  for (const calc::SurfaceSide& side : all) {
    if (side.triangle >= 12) continue;
    ++of_room;
    const glm::uvec3& t = room.scene.triangle[side.triangle];
    const glm::dvec3 inwards = glm::dvec3(2, 1.5, 1.25) - glm::dvec3(room.scene.vertex_m[t.x]);
    EXPECT_GT(glm::dot(glm::dvec3(side.normal), inwards), 0.0) << side.triangle;
  }
  EXPECT_EQ(of_room, 12U);
  EXPECT_EQ(all.size(), 12U + 2 * 12U);
  for (const glm::dvec3& eye : {glm::dvec3(-6, -9, 9), {9, 12, -7}, {20, -1, 3}}) {
    for (const calc::SurfaceSide& side : calc::cut_away(tracer, eye, true).shown)
      EXPECT_NE(std::find(all.begin(), all.end(), side), all.end());
  }
  EXPECT_EQ(calc::sides_from_everywhere(tracer, false).size(), 2 * room.scene.triangle.size());
}

}  // namespace
}  // namespace cutaway_test
