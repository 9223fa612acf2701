#include "calc/meshes/mesh_shells.h"

#include <gtest/gtest.h>

#include <utility>

namespace calc::mesh_shells_test {
namespace {

struct Triangles {
  std::vector<glm::dvec3> vertex;
  std::vector<glm::uvec3> triangle;

  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto first = static_cast<unsigned>(vertex.size());
    for (const glm::dvec3& p : {a, b, c}) vertex.push_back(p);
    triangle.emplace_back(first, first + 1, first + 2);
  }
  // Every corner has vertices of its own, so that they must be welded. Outward.
  void add_box(const glm::dvec3& low, const glm::dvec3& high) {
    const auto at = [&](unsigned i) {
      return glm::dvec3(i & 1u ? high.x : low.x, i & 2u ? high.y : low.y, i & 4u ? high.z : low.z);
    };
    constexpr unsigned kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
    for (const auto& f : kFaces) {
      add(at(f[0]), at(f[1]), at(f[2]));
      add(at(f[0]), at(f[2]), at(f[3]));
    }
  }
  void turn(std::size_t index) { std::swap(triangle[index].y, triangle[index].z); }
  std::vector<MeshShell> shells() const { return find_shells(vertex, triangle); }
};

TEST(MeshShells, TheSignOfTheVolumeSaysWhichWayFacesLook) {
  Triangles box;
  box.add_box({100, 0, 0}, {104, 3, 2.5});  // far from the origin
  ASSERT_EQ(box.shells().size(), 1u);
  MeshShell shell = box.shells()[0];
  EXPECT_TRUE(shell.is_closed);
  EXPECT_EQ(shell.faces, FacesLook::outward);
  EXPECT_EQ(shell.outward, 12u);
  EXPECT_NEAR(shell.volume, 30.0, 1e-9);
  for (std::size_t i = 0; i < 12; ++i) box.turn(i);
  shell = box.shells()[0];
  EXPECT_EQ(shell.faces, FacesLook::inward);
  EXPECT_EQ(shell.outward, 0u);
  EXPECT_NEAR(shell.volume, 30.0, 1e-9);
  for (std::size_t i = 3; i < 12; ++i) box.turn(i);
  shell = box.shells()[0];
  EXPECT_TRUE(shell.is_closed);
  EXPECT_EQ(shell.faces, FacesLook::mixed);
  EXPECT_EQ(shell.outward, 9u);
  EXPECT_NEAR(shell.volume, 30.0, 1e-9);
}

TEST(MeshShells, ShellsThatTouchAlongAnEdgeAreTwo) {
  Triangles boxes;
  boxes.add_box({0, 0, 0}, {1, 1, 1});
  boxes.add_box({1, 1, 0}, {2, 2, 1});
  const std::vector<MeshShell> shells = boxes.shells();
  ASSERT_EQ(shells.size(), 2u);
  for (const MeshShell& shell : shells) {
    EXPECT_TRUE(shell.is_closed);
    EXPECT_EQ(shell.faces, FacesLook::outward);
    EXPECT_EQ(shell.triangle.size(), 12u);
  }
  EXPECT_EQ(shells[1].triangle.front(), 12u);
}

TEST(MeshShells, WhatSharesAWholeFaceHasNoSides) {
  Triangles boxes;
  boxes.add_box({0, 0, 0}, {1, 1, 1});
  boxes.add_box({1, 0, 0}, {2, 1, 1});
  const std::vector<MeshShell> shells = boxes.shells();
  ASSERT_EQ(shells.size(), 1u);
  EXPECT_TRUE(shells[0].is_closed);
  EXPECT_EQ(shells[0].faces, FacesLook::unclear);
  EXPECT_EQ(open_edges(boxes.vertex, boxes.triangle).count, 0u);
}

TEST(MeshShells, OpenEdgesAreMeasured) {
  Triangles box;
  box.add_box({0, 0, 0}, {4, 3, 2.5});
  EXPECT_EQ(open_edges(box.vertex, box.triangle).count, 0u);
  box.triangle.erase(box.triangle.begin() + 2, box.triangle.begin() + 4);  // the ceiling
  EXPECT_FALSE(box.shells()[0].is_closed);
  const OpenEdges open = open_edges(box.vertex, box.triangle);
  EXPECT_EQ(open.count, 4u);
  EXPECT_DOUBLE_EQ(open.length, 14.0);
  EXPECT_DOUBLE_EQ(open.longest, 4.0);
  EXPECT_DOUBLE_EQ(open.at.z, 2.5);
  EXPECT_TRUE(encloses_something(box.vertex, box.triangle));
}

TEST(MeshShells, SheetsAndTraysEncloseNothing) {
  Triangles sheet;
  sheet.add({0, 0, 0}, {4, 0, 0}, {4, 3, 0});
  sheet.add({0, 0, 0}, {4, 3, 0}, {0, 3, 0});
  EXPECT_FALSE(encloses_something(sheet.vertex, sheet.triangle));
  Triangles tray;
  tray.add_box({0, 0, 0}, {4, 3, 0.2});
  tray.triangle.erase(tray.triangle.begin() + 2, tray.triangle.begin() + 4);
  EXPECT_FALSE(encloses_something(tray.vertex, tray.triangle));
  EXPECT_FALSE(encloses_something({}, {}));
}

TEST(MeshShells, TheFloorIsTheLowestLevelPolygon) {
  Triangles box;
  box.add_box({1, 2, 0.5}, {5, 5, 3});
  const MeshFloor floor = find_floor(box.vertex, box.triangle);
  ASSERT_EQ(floor.outline.size(), 4u);
  EXPECT_DOUBLE_EQ(floor.z, 0.5);
  EXPECT_DOUBLE_EQ(floor.height, 2.5);
  EXPECT_NEAR(floor.above, 0.0, 1e-12);
}

// A pit of 1 m2 in the floor of a room of 12 m2 is no floor of the room.
TEST(MeshShells, APitIsNoFloor) {
  Triangles room;
  room.add_box({0, 0, -1}, {1, 1, 0});                                        // the pit
  room.triangle.erase(room.triangle.begin() + 2, room.triangle.begin() + 4);  // and its lid
  room.add({1, 0, 0}, {4, 0, 0}, {4, 3, 0});
  room.add({1, 0, 0}, {4, 3, 0}, {1, 3, 0});
  room.add({0, 1, 0}, {1, 1, 0}, {1, 3, 0});
  room.add({0, 1, 0}, {1, 3, 0}, {0, 3, 0});
  room.add({0, 0, 3}, {4, 0, 3}, {4, 3, 3});
  room.add({0, 0, 3}, {4, 3, 3}, {0, 3, 3});
  const MeshFloor floor = find_floor(room.vertex, room.triangle);
  EXPECT_TRUE(floor.outline.empty());
  EXPECT_NEAR(floor.above, 11.0, 1e-9);
}

// Two storeys' floors with a hole, and two separate ones, are no outline of a room.
TEST(MeshShells, AFloorWithAHoleOrInTwoPartsHasNoOutline) {
  Triangles parts;
  parts.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  parts.add({5, 0, 0}, {6, 0, 0}, {5, 1, 0});
  parts.add({0, 0, 2}, {1, 0, 2}, {0, 1, 2});
  parts.add({5, 0, 2}, {6, 0, 2}, {5, 1, 2});
  EXPECT_TRUE(find_floor(parts.vertex, parts.triangle).outline.empty());
  Triangles ring;
  const glm::dvec3 o[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const glm::dvec3 i[] = {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  for (int k = 0; k < 4; ++k) {
    const int n = (k + 1) % 4;
    ring.add(o[k], o[n], i[n]);
    ring.add(o[k], i[n], i[k]);
  }
  EXPECT_TRUE(find_floor(ring.vertex, ring.triangle).outline.empty());
}

}  // namespace
}  // namespace calc::mesh_shells_test
