#include "calc/rays/triangle_hit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace triangle_hit_test {
namespace {

using calc::Ray;
using calc::Triangle;
using calc::TriangleHit;

TEST(MeetsTriangle, GivesTheDistanceAndThePlaceOnTheTriangle) {
  const Triangle triangle{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  TriangleHit hit;
  ASSERT_TRUE(calc::meets({{1, 2, 0}, {0, 0, 0.5f}}, triangle, hit));
  EXPECT_DOUBLE_EQ(hit.t, 4.0);  // in lengths of the direction
  EXPECT_DOUBLE_EQ(hit.u, 0.25);
  EXPECT_DOUBLE_EQ(hit.v, 0.5);
  EXPECT_TRUE(calc::meets({{1, 2, 3}, {0, 0, -1}}, triangle, hit)) << "from the other side";
  EXPECT_FALSE(calc::meets({{3, 2, 0}, {0, 0, 1}}, triangle, hit)) << "beside it";
  EXPECT_FALSE(calc::meets({{1, 2, 0}, {0, 0, -1}}, triangle, hit)) << "behind the origin";
}

TEST(MeetsTriangle, BothEndsOfTheRayAreLeftOut) {
  const Triangle triangle{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
  TriangleHit hit;
  EXPECT_FALSE(calc::meets({{0, 0, 0}, {0, 0, 1}, 0.0f, 1.0f}, triangle, hit));
  EXPECT_FALSE(calc::meets({{0, 0, 0}, {0, 0, 1}, 1.0f, 2.0f}, triangle, hit));
  EXPECT_TRUE(calc::meets({{0, 0, 0}, {0, 0, 1}, 0.999f, 1.001f}, triangle, hit));
}

TEST(MeetsTriangle, ARayInThePlaneDoesNotMeetTheTriangle) {
  TriangleHit hit;
  EXPECT_FALSE(calc::meets({{-1, 0.25f, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, hit));
  EXPECT_FALSE(calc::meets({{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}}, hit))
      << "a triangle without area";
}

// Two triangles on one edge, which stands in the one or the other direction in each: a ray that
// comes as near to the edge as numbers can hold meets at least one, and it meets two only exactly
// over the edge.
TEST(MeetsTriangle, NoRaySlipsThroughAnEdge) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> at(-3.0f, 3.0f);
  const auto point = [&] { return glm::vec3(at(random), at(random), at(random)); };
  int both = 0;
  for (int n = 0; n < 200000; ++n) {
    const glm::vec3 a = point(), b = point(), origin = point();
    const glm::vec3 on_edge = a + 0.5f * (1.0f + at(random) / 3.0f) * (b - a);
    const glm::vec3 direction = on_edge - origin;
    // One corner on each side of the plane through the origin and the edge, as the ray sees it.
    const glm::dvec3 across = glm::cross(glm::dvec3(a - origin), glm::dvec3(b - origin));
    if (glm::length(across) < 1e-3) continue;
    const glm::dvec3 side = glm::normalize(across);
    const glm::dvec3 middle = 0.5 * glm::dvec3(a + b);
    const glm::dvec3 left(glm::vec3(middle + 5.0 * side)), right(glm::vec3(middle - 5.0 * side));
    const bool turned = n % 2 == 0;
    const Triangle one{glm::dvec3(a), glm::dvec3(b), left};
    const Triangle two = turned ? Triangle{right, glm::dvec3(b), glm::dvec3(a)}
                                : Triangle{glm::dvec3(a), right, glm::dvec3(b)};
    TriangleHit hit;
    const bool meets_one = calc::meets({origin, direction}, one, hit);
    const bool meets_two = calc::meets({origin, direction}, two, hit);
    ASSERT_TRUE(meets_one || meets_two) << n;
    if (meets_one && meets_two) ++both;
  }
  EXPECT_LT(both, 2000);
}

TEST(TriangleHit, OfEquallyNearOnesTheFirstTriangleComesFirst) {
  const TriangleHit near{7, 1.0, 0, 0}, far{1, 2.0, 0, 0}, equal{3, 1.0, 0, 0};
  EXPECT_TRUE(near.is_before(far));
  EXPECT_TRUE(equal.is_before(near));
  EXPECT_FALSE(near.is_before(equal));
  EXPECT_TRUE(near.is_before(TriangleHit{}));
}

}  // namespace
}  // namespace triangle_hit_test
