#include "calc/scene/solids.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace calc::solids_test {
namespace {

// 12 triangles; every second one turns the wrong way if asked for.
Body box(glm::dvec3 lower, glm::dvec3 upper, bool mixed_turns = false) {
  Body body;
  body.id = "box";
  for (int i = 0; i < 8; ++i) {
    body.vertex_m.emplace_back((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                               (i & 4) != 0 ? upper.z : lower.z);
  }
  const std::vector<glm::uvec4> quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const glm::uvec4& q : quads) {
    body.triangle.emplace_back(q.x, q.y, q.z);
    if (mixed_turns)
      body.triangle.emplace_back(q.w, q.z, q.x);
    else
      body.triangle.emplace_back(q.x, q.z, q.w);
  }
  return body;
}

// The same triangles, each with three vertices of its own.
Body unwelded(const Body& body) {
  Body loose;
  for (const glm::uvec3& t : body.triangle) {
    const auto first = static_cast<std::uint32_t>(loose.vertex_m.size());
    for (int i = 0; i < 3; ++i) loose.vertex_m.push_back(body.vertex_m[t[i]]);
    loose.triangle.emplace_back(first, first + 1, first + 2);
  }
  return loose;
}

void append(Body& body, const Body& other) {
  const auto first = static_cast<std::uint32_t>(body.vertex_m.size());
  body.vertex_m.insert(body.vertex_m.end(), other.vertex_m.begin(), other.vertex_m.end());
  for (const glm::uvec3& t : other.triangle) body.triangle.push_back(t + first);
}

SolidSide side(const Body& body, const glm::dvec3& point) {
  return locate_point(body, bounding_box(body.vertex_m), point);
}

TEST(Watertight, ClosedBoxesAreWhateverTheirVerticesAndTurns) {
  EXPECT_TRUE(is_watertight(box({0, 0, 0}, {1, 2, 3})));
  EXPECT_TRUE(is_watertight(box({0, 0, 0}, {1, 2, 3}, true)));
  EXPECT_TRUE(is_watertight(unwelded(box({-1, -1, -1}, {0, 0, 0}))));
}

TEST(Watertight, NegativeZeroIsZero) {
  Body body = unwelded(box({0, 0, 0}, {1, 1, 1}));
  for (glm::dvec3& p : body.vertex_m) {
    if (&p - body.vertex_m.data() < 9 && p.x == 0.0) p.x = -0.0;
  }
  EXPECT_TRUE(is_watertight(body));
}

TEST(Watertight, OpenBodiesAreNot) {
  Body open = box({0, 0, 0}, {1, 1, 1});
  open.triangle.pop_back();
  EXPECT_FALSE(is_watertight(open));
  EXPECT_FALSE(is_watertight(Body{}));
  Body half_closed = box({0, 0, 0}, {1, 1, 1});
  Body sheet;
  sheet.vertex_m = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  sheet.triangle = {{0, 1, 2}};
  append(half_closed, sheet);
  EXPECT_FALSE(is_watertight(half_closed));
}

TEST(Watertight, AGapOfOneCoordinateIsAGap) {
  Body body = unwelded(box({0, 0, 0}, {1, 1, 1}));
  body.vertex_m[0].x += 1e-9;
  EXPECT_FALSE(is_watertight(body));
}

TEST(SolidSides, AGridThroughABoxIsSplitExactly) {
  const Body body = box({0, 0, 0}, {4, 4, 4}, true);
  for (int x = -1; x <= 5; ++x) {
    for (int y = -1; y <= 5; ++y) {
      for (int z = -1; z <= 5; ++z) {  // many of them level with edges and diagonals
        const bool out = x < 0 || y < 0 || z < 0 || x > 4 || y > 4 || z > 4;
        const bool in = x > 0 && y > 0 && z > 0 && x < 4 && y < 4 && z < 4;
        const SolidSide expected = out  ? SolidSide::outside
                                   : in ? SolidSide::inside
                                        : SolidSide::on_surface;
        EXPECT_EQ(side(body, {x, y, z}), expected) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(SolidSides, TheSurfaceIsThin) {
  const Body body = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(side(body, {0.3, 0.4, 1.0 - 1e-10}), SolidSide::on_surface);
  EXPECT_EQ(side(body, {0.3, 0.4, 1.0 + 1e-10}), SolidSide::on_surface);
  EXPECT_EQ(side(body, {0.3, 0.4, 1.0 - 1e-7}), SolidSide::inside);
  EXPECT_EQ(side(body, {0.3, 0.4, 1.0 + 1e-7}), SolidSide::outside);
}

TEST(SolidSides, HoldFarFromTheOrigin) {
  const glm::dvec3 far(6.0e6, -5.0e6, 300.0);
  const Body body = box(far, far + glm::dvec3(1.2, 0.8, 0.75));
  EXPECT_EQ(side(body, far + glm::dvec3(0.6, 0.4, 0.75)), SolidSide::on_surface);
  EXPECT_EQ(side(body, far + glm::dvec3(0.6, 0.4, 0.749)), SolidSide::inside);
  EXPECT_EQ(side(body, far + glm::dvec3(0.6, 0.4, 0.751)), SolidSide::outside);
}

TEST(SolidSides, ABoxInABoxIsAShell) {
  Body shell = box({0, 0, 0}, {3, 3, 3});
  append(shell, box({1, 1, 1}, {2, 2, 2}));
  ASSERT_TRUE(is_watertight(shell));
  EXPECT_EQ(side(shell, {0.5, 1.5, 1.5}), SolidSide::inside);
  EXPECT_EQ(side(shell, {1.5, 1.5, 1.5}), SolidSide::outside) << "the hollow";
  EXPECT_EQ(side(shell, {3.5, 1.5, 1.5}), SolidSide::outside);
}

TEST(SolidSides, ConcaveSolidsAreFollowed) {
  Body u_shape = box({0, 0, 0}, {3, 1, 1});
  append(u_shape, box({0, 0, 1}, {1, 1, 3}));
  append(u_shape, box({2, 0, 1}, {3, 1, 3}));
  EXPECT_EQ(side(u_shape, {1.5, 0.5, 2.0}), SolidSide::outside);
  EXPECT_EQ(side(u_shape, {0.5, 0.5, 2.0}), SolidSide::inside);
  EXPECT_EQ(side(u_shape, {1.5, 0.5, 0.5}), SolidSide::inside);
}

TEST(SolidSides, FlatTrianglesDoNotCount) {
  Body body = box({0, 0, 0}, {1, 1, 1});
  body.triangle.emplace_back(0, 0, 7);
  EXPECT_TRUE(is_watertight(body));
  EXPECT_EQ(side(body, {0.2, 0.3, 0.4}), SolidSide::inside);
  EXPECT_EQ(side(body, {1.2, 0.3, 0.4}), SolidSide::outside);
}

TEST(Box, KnowsWhatItHolds) {
  BoundingBox none;
  EXPECT_TRUE(none.is_empty());
  EXPECT_EQ(none.diagonal(), 0.0);
  EXPECT_FALSE(none.contains({0, 0, 0}));
  const BoundingBox some = bounding_box({{1, 5, 2}, {4, 1, 2}});
  EXPECT_FALSE(some.is_empty());
  EXPECT_DOUBLE_EQ(some.diagonal(), 5.0);
  EXPECT_EQ(some.centre(), glm::dvec3(2.5, 3.0, 2.0));
  EXPECT_TRUE(some.contains({4, 5, 2}));
  EXPECT_FALSE(some.contains({4, 5.1, 2}));
}

// Corners, edges and faces of a coarse grid, and places between.
TEST(SolidLocator, SaysWhatLocatePointSays) {
  Body both = box({0, 0, 0}, {2, 1, 1});
  const Body other = box({0.5, 0.25, 1}, {1, 0.75, 2});
  const auto first = static_cast<std::uint32_t>(both.vertex_m.size());
  both.vertex_m.insert(both.vertex_m.end(), other.vertex_m.begin(), other.vertex_m.end());
  for (const glm::uvec3& t : other.triangle) both.triangle.push_back(t + first);
  const SolidLocator locator(both);
  const BoundingBox bounds = bounding_box(both.vertex_m);
  int inside = 0;
  for (int z = -1; z <= 17; ++z) {
    for (int y = -1; y <= 9; ++y) {
      for (int x = -1; x <= 17; ++x) {
        const glm::dvec3 point(0.125 * x, 0.125 * y, 0.125 * z);
        const SolidSide side = locate_point(both, bounds, point);
        ASSERT_EQ(locator.locate(point), side) << x << " " << y << " " << z;
        inside += side == SolidSide::inside ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 500);
}

}  // namespace
}  // namespace calc::solids_test
