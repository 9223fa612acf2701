#include "calc/scene/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

namespace calc::polygon_test {
namespace {

using Outline = std::vector<glm::dvec2>;
using Loop = std::vector<glm::dvec3>;

const Outline kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Outline kLShape = {{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}};  // 12 + 9 m2
const Outline kBowTie = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};

Outline moved(Outline outline, glm::dvec2 by) {
  for (glm::dvec2& p : outline) p += by;
  return outline;
}

Outline reversed(const Outline& outline) { return Outline(outline.rbegin(), outline.rend()); }

double triangle_area(const Outline& p, const glm::uvec3& t) {
  return signed_area({p[t.x], p[t.y], p[t.z]});
}

// Every triangle turns as the outline does and is not flat, they fill it, and no corner is left
// over.
void expect_exact_cover(const Outline& outline) {
  const auto triangles = triangulate_polygon(outline);
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->size(), outline.size() - 2);
  const double area = signed_area(outline);
  double sum = 0.0;
  std::set<std::uint32_t> used;
  for (const glm::uvec3& t : *triangles) {
    const double part = triangle_area(outline, t);
    EXPECT_GT(part * area, 0.0);
    sum += part;
    used.insert({t.x, t.y, t.z});
  }
  EXPECT_NEAR(sum, area, 1e-9 * std::abs(area));
  EXPECT_EQ(used.size(), outline.size());
}

Outline star(int points) {
  Outline outline;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = 3.14159265358979 * i / points, radius = i % 2 == 0 ? 1.0 : 0.3;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

TEST(Polygon, AreaIsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(signed_area(kLShape), 21.0);
  EXPECT_DOUBLE_EQ(signed_area(reversed(kLShape)), -21.0);
  EXPECT_EQ(signed_area({{0, 0}, {1, 1}}), 0.0);
  EXPECT_EQ(signed_area({}), 0.0);
}

TEST(Polygon, AreaIsExactFarFromTheOrigin) {
  EXPECT_DOUBLE_EQ(signed_area(moved(kLShape, {4.0e6, -5.0e6})), 21.0);
}

TEST(Polygon, SimpleOutlinesAreAccepted) {
  EXPECT_TRUE(is_simple_polygon(kSquare));
  EXPECT_TRUE(is_simple_polygon(kLShape));
  EXPECT_TRUE(is_simple_polygon(reversed(kLShape)));
  EXPECT_TRUE(is_simple_polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})) << "corner on a side";
  EXPECT_TRUE(is_simple_polygon({{0, 0}, {100, 0}, {100, 0.001}})) << "needle";
  EXPECT_TRUE(is_simple_polygon(star(9)));
}

TEST(Polygon, SizeAndPlaceDoNotMatter) {
  Outline tiny = kLShape, huge = kLShape;
  for (glm::dvec2& p : tiny) p *= 1e-7;
  for (glm::dvec2& p : huge) p *= 1e7;
  EXPECT_TRUE(is_simple_polygon(tiny));
  EXPECT_TRUE(is_simple_polygon(huge));
  EXPECT_TRUE(is_simple_polygon(moved(kLShape, {1e6, 1e6})));
}

TEST(Polygon, OutlinesThatTouchThemselvesAreRefused) {
  EXPECT_FALSE(is_simple_polygon(kBowTie));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}})) << "corner on a side";
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {2, 0}, {2, 2}, {2, 3}, {2, 2}, {0, 2}})) << "spike";
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {2, 0}, {2, 0}, {2, 2}})) << "equal corners";
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}})) << "repeated start";
}

TEST(Polygon, OutlinesWithoutAreaAreRefused) {
  EXPECT_FALSE(is_simple_polygon({}));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {1, 1}}));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {1, 0}, {std::nan(""), 1}}));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {1, 0}, {1, std::numeric_limits<double>::infinity()}}));
}

TEST(Polygon, ContainsFollowsAConcaveOutline) {
  for (const Outline& outline : {kLShape, reversed(kLShape)}) {
    EXPECT_TRUE(contains_point(outline, {5.9, 1.9}));
    EXPECT_TRUE(contains_point(outline, {2.9, 4.9}));
    EXPECT_FALSE(contains_point(outline, {3.1, 2.1}));
    EXPECT_FALSE(contains_point(outline, {-0.1, 2.0})) << "level with two corners";
    EXPECT_TRUE(contains_point(outline, {1.0, 2.0})) << "level with two corners";
    EXPECT_FALSE(contains_point(outline, {7.0, 5.0}));
  }
}

TEST(Polygon, TheBoundaryIsInside) {
  EXPECT_TRUE(contains_point(kLShape, {3.0, 3.0}));
  EXPECT_TRUE(contains_point(kLShape, {3.0, 2.0}));
  EXPECT_TRUE(contains_point(kLShape, {6.0 + 1e-10, 1.0}));
  EXPECT_FALSE(contains_point(kLShape, {6.0 + 1e-7, 1.0}));
  EXPECT_TRUE(contains_point(moved(kLShape, {1e6, 0}), {1e6 + 6.0, 1.3}));
}

TEST(Polygon, DistanceIsToTheNearestSide) {
  EXPECT_DOUBLE_EQ(distance_to_boundary(kLShape, {1.0, 1.5}), 1.0);
  EXPECT_DOUBLE_EQ(distance_to_boundary(kLShape, {6.0 + 3.0, 2.0 + 4.0}), 5.0) << "to a corner";
  EXPECT_DOUBLE_EQ(distance_to_boundary(kLShape, {2.5, 1.5}), std::hypot(0.5, 0.5));
  EXPECT_TRUE(std::isinf(distance_to_boundary({}, {0, 0})));
}

TEST(Triangulation, FillsConvexConcaveAndReversedOutlines) {
  expect_exact_cover({{0, 0}, {1, 0}, {0, 1}});
  expect_exact_cover(kSquare);
  expect_exact_cover(kLShape);
  expect_exact_cover(reversed(kLShape));
  expect_exact_cover(star(7));
  expect_exact_cover(moved(kLShape, {1e6, 2e6}));
}

TEST(Triangulation, UsesCornersOnStraightSides) {
  expect_exact_cover({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {1.5, 3}, {0, 3}, {0, 1}});
  expect_exact_cover({{0, 0}, {4, 0}, {3, 1}, {2, 2}, {1, 3}, {0, 4}});
  // Noise of a projection: the middle corners are 1e-16 off the side.
  expect_exact_cover({{0, 0}, {1, 1.1e-16}, {2, -2.2e-16}, {3, 0}, {3, 3}, {0, 3}});
}

TEST(Triangulation, FillsASpiralAndALongComb) {
  expect_exact_cover({{0, 0},
                      {10, 0},
                      {10, 10},
                      {2, 10},
                      {2, 4},
                      {6, 4},
                      {6, 6},
                      {4, 6},
                      {4, 8},
                      {8, 8},
                      {8, 2},
                      {0, 2}});
  Outline comb = {{200, -1}, {0, -1}};
  for (int i = 0; i < 200; ++i) {
    comb.emplace_back(i, 0.0);
    comb.emplace_back(i + 0.5, 9.0);
  }
  comb.emplace_back(200.0, 0.0);
  expect_exact_cover(comb);
}

TEST(Triangulation, RefusesWhatIsNotSimple) {
  EXPECT_FALSE(triangulate_polygon(kBowTie));
  EXPECT_FALSE(triangulate_polygon(Outline{{0, 0}, {1, 1}}));
}

TEST(Triangulation, WorksInTheOwnPlaneOfAPolygonInSpace) {
  // The L on a steep plane: x = (1, 2, 2) / 3, y = (2, 1, -2) / 3.
  const glm::dvec3 x = glm::dvec3(1, 2, 2) / 3.0, y = glm::dvec3(2, 1, -2) / 3.0;
  Loop corners;
  for (const glm::dvec2& p : kLShape) corners.push_back(glm::dvec3(1e6, 5, 7) + p.x * x + p.y * y);
  const auto triangles = triangulate_polygon(corners);
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->size(), 4u);
  glm::dvec3 area(0.0);
  for (const glm::uvec3& t : *triangles) {
    area += 0.5 * glm::cross(corners[t.y] - corners[t.x], corners[t.z] - corners[t.x]);
  }
  EXPECT_NEAR(glm::length(area - 21.0 * glm::cross(x, y)), 0.0, 1e-6);
}

TEST(Triangulation, RefusesBentCrossingAndFlatLoops) {
  EXPECT_FALSE(triangulate_polygon(Loop{{0, 0, 0}, {2, 0, 0}, {2, 2, 0.01}, {0, 2, 0}}));
  EXPECT_TRUE(triangulate_polygon(Loop{{0, 0, 0}, {2, 0, 0}, {2, 2, 1e-7}, {0, 2, 0}}));
  EXPECT_FALSE(triangulate_polygon(Loop{{0, 0, 1}, {2, 2, 1}, {2, 0, 1}, {-1, 2, 1}}));
  EXPECT_FALSE(triangulate_polygon(Loop{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(triangulate_polygon(Loop{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
  EXPECT_FALSE(triangulate_polygon(Loop{{0, 0, 0}, {1, 0, 0}, {1, std::nan(""), 0}}));
}

TEST(FlatPolygon, StatesHowFarItWasBent) {
  const auto flat = flatten_polygon({{0, 0, 0.1}, {2, 0, -0.1}, {2, 2, 0.1}, {0, 2, -0.1}});
  ASSERT_TRUE(flat);
  EXPECT_NEAR(signed_area(flat->corner), 4.0, 1e-12);
  EXPECT_NEAR(flat->deviation, 0.1 / std::sqrt(8.0), 1e-12);
}

}  // namespace
}  // namespace calc::polygon_test
