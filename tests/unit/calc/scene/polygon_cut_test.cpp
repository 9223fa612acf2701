#include "calc/scene/polygon_cut.h"

#include <gtest/gtest.h>

namespace calc::polygon_cut_test {
namespace {

const std::vector<glm::dvec2> kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

bool covers(const std::vector<ConvexPiece>& pieces, glm::dvec2 p) {
  int hits = 0;
  for (const ConvexPiece& piece : pieces) {
    bool inside = true;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const glm::dvec2 a = piece[i], b = piece[(i + 1) % piece.size()];
      inside = inside && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0.0;
    }
    if (inside) ++hits;
  }
  EXPECT_LE(hits, 1) << "pieces overlap";
  return hits > 0;
}

TEST(PolygonCut, PiecesRunCounterClockwise) {
  const std::vector<glm::dvec2> clockwise(kSquare.rbegin(), kSquare.rend());
  EXPECT_DOUBLE_EQ(area(convex_pieces(kSquare)), 16.0);
  EXPECT_DOUBLE_EQ(area(convex_pieces(clockwise)), 16.0);
  EXPECT_TRUE(convex_pieces({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).empty());
}

TEST(PolygonCut, AHoleIsCutOutOnce) {
  const ConvexPiece hole{{1, 1}, {2, 1}, {3, 2}, {1, 3}};
  const std::vector<ConvexPiece> left = cut_out(convex_pieces(kSquare), hole);
  EXPECT_NEAR(area(left), 16.0 - area({hole}), 1e-12);
  for (double x = 0.137; x < 4.0; x += 0.31) {
    for (double y = 0.151; y < 4.0; y += 0.29) {
      EXPECT_NE(covers(left, {x, y}), covers({hole}, {x, y})) << x << ' ' << y;
    }
  }
}

TEST(PolygonCut, HolesOutsideCutNothing) {
  const std::vector<ConvexPiece> pieces = convex_pieces(kSquare);
  EXPECT_EQ(cut_out(pieces, {{5, 0}, {6, 0}, {6, 1}}), pieces);
  EXPECT_EQ(cut_out(pieces, {{4, 0}, {6, 0}, {6, 4}, {4, 4}}), pieces) << "they only touch";
}

TEST(PolygonCut, AHoleOverAllLeavesNothing) {
  EXPECT_TRUE(cut_out(convex_pieces(kSquare), {{-1, -1}, {5, -1}, {5, 5}, {-1, 5}}).empty());
  EXPECT_TRUE(cut_out(convex_pieces(kSquare), kSquare).empty());
}

}  // namespace
}  // namespace calc::polygon_cut_test
