#include "calc/scene/zone_shapes.h"

#include "calc/scene/polygon.h"

#include <gtest/gtest.h>

namespace calc::zone_shapes_test {
namespace {

using Polygon = std::vector<glm::dvec2>;

const Polygon kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Polygon kEl{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}};

TEST(MovedSides, KeepsCornersSharp) {
  const Polygon wider = moved_sides(kSquare, 0.5);
  ASSERT_EQ(wider.size(), 4u);
  EXPECT_NEAR(signed_area(wider), 25.0, 1e-12);
  EXPECT_NEAR(glm::distance(wider[0], glm::dvec2(-0.5, -0.5)), 0.0, 1e-12);
  // 6 x 2 and 2 x 4 m: half a metre more on every side.
  EXPECT_NEAR(signed_area(moved_sides(kEl, 0.5)), 7 * 3 + 3 * 4, 1e-12);
  EXPECT_NEAR(signed_area(moved_sides(kEl, -0.5)), 5 * 1 + 1 * 4, 1e-12);
}

TEST(MovedSides, CornersOnAStraightSideDoNotMatter) {
  EXPECT_NEAR(signed_area(moved_sides({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.5)), 25.0, 1e-12);
}

TEST(MovedSides, NothingSimpleIsNothing) {
  EXPECT_TRUE(moved_sides(kSquare, -2.0).empty());
  EXPECT_TRUE(moved_sides(kSquare, -3.0).empty());
  EXPECT_TRUE(moved_sides(kEl, -1.0).empty());
  // A slot of 0.8 m closes when both its sides move by 0.5 m.
  EXPECT_TRUE(
      moved_sides({{0, 0}, {4, 0}, {4, 3}, {2.4, 3}, {2.4, 1}, {1.6, 1}, {1.6, 3}, {0, 3}}, 0.5)
          .empty());
}

TEST(WithinBounds, CutsAtTheRegionsRectangle) {
  const Polygon cut = within_bounds(kSquare, {{1, -1}, {9, -1}, {9, 3}, {1, 3}});
  EXPECT_NEAR(signed_area(cut), 3 * 3, 1e-12);
  EXPECT_EQ(within_bounds(kSquare, {{-1, -1}, {9, -1}, {9, 9}, {-1, 9}}), kSquare);
  EXPECT_TRUE(within_bounds(kSquare, {{4, 0}, {9, 0}, {9, 4}, {4, 4}}).empty());
}

TEST(PiecesOutside, AreWhatARegionDoesNotCover) {
  double outside = 0.0;
  for (const Polygon& piece : pieces_outside(kSquare, kEl)) outside += signed_area(piece);
  EXPECT_NEAR(outside, 2 * 2, 1e-12);
  EXPECT_TRUE(pieces_outside({{0, 0}, {6, 0}, {6, 2}, {0, 2}}, kEl).empty());
}

TEST(AreaLeft, CountsOverlappingHolesOnce) {
  EXPECT_NEAR(area_left(kSquare, {}), 16.0, 1e-12);
  EXPECT_NEAR(
      area_left(kSquare, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{2, 2}, {9, 2}, {9, 9}, {2, 9}}}),
      16 - 4 - 4 + 1, 1e-12);
}

}  // namespace
}  // namespace calc::zone_shapes_test
