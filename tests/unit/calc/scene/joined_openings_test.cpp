#include "calc/scene/joined_openings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace calc::joined_openings_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

OpeningInPlace panel(double x_m, double y_m, double z_m = 3.0, double turn_rad = 0.0,
                     double along_m = 0.6, double across_m = 0.6) {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  return {{x_m, y_m, z_m},
          {{c, s, 0}, {-s, c, 0}, {0, 0, 1}},
          {OpeningShape::rectangle, along_m, across_m, 0.0}};
}

TEST(JoinedOpenings, AreThoseThatTouchAlongASide) {
  const std::vector<OpeningInPlace> four{panel(0, 0), panel(5, 5), panel(0.6, 0), panel(0.6, 0.62)};
  const std::vector<JoinedOpening> joined = joined_openings(four);
  ASSERT_THAT(joined, SizeIs(1));
  EXPECT_THAT(joined[0].members, ElementsAre(0, 2, 3));
  EXPECT_NEAR(joined[0].width_m, 1.2, 1e-9);
}

TEST(JoinedOpenings, NeedOnePlaneAndLittleBetween) {
  const auto join = [](const OpeningInPlace& other) {
    return !joined_openings(std::vector<OpeningInPlace>{panel(0, 0), other}).empty();
  };
  EXPECT_TRUE(join(panel(0.65, 0)));
  EXPECT_FALSE(join(panel(0.7, 0)));
  EXPECT_FALSE(join(panel(0.6, 0, 3.1)));
  EXPECT_FALSE(join(panel(0.6, 0.6))) << "corners alone";
  EXPECT_TRUE(join(panel(0.6, 0.1, 3.0, 0.5 * 3.14159265)));
  OpeningInPlace point = panel(0.1, 0);
  point.opening = {};
  EXPECT_FALSE(join(point));
}

TEST(JoinedOpenings, LinesOfLuminairesAreNone) {
  std::vector<OpeningInPlace> line;
  for (int k = 0; k < 20; ++k) line.push_back(panel(1.5 * k, 0, 3.0, 0.0, 1.5, 0.1));
  EXPECT_THAT(joined_openings(line), IsEmpty());
  for (int k = 0; k < 20; ++k) line.push_back(panel(1.5 * k, 0.1, 3.0, 0.0, 1.5, 0.1));
  EXPECT_THAT(joined_openings(line), IsEmpty()) << "two side by side are 0.2 m wide";
  for (int n = 2; n < 5; ++n) line.push_back(panel(0.0, 0.1 * n, 3.0, 0.0, 1.5, 0.1));
  EXPECT_THAT(joined_openings(line), SizeIs(1));
}

TEST(JoinedOpenings, AFrameOfLinesIsNoCeiling) {
  const double quarter = 0.5 * 3.14159265358979;
  std::vector<OpeningInPlace> frame;
  for (const double y_m : {0.0, 4.5}) {
    for (int k = 0; k < 3; ++k) frame.push_back(panel(0.8 + 1.5 * k, y_m, 3.0, 0.0, 1.5, 0.1));
  }
  for (const double x_m : {0.0, 4.6}) {
    for (int k = 0; k < 3; ++k) frame.push_back(panel(x_m, 0.75 + 1.5 * k, 3.0, quarter, 1.5, 0.1));
  }
  EXPECT_THAT(joined_openings(frame), IsEmpty());
  std::vector<OpeningInPlace> small_tiles;
  for (int k = 0; k < 64; ++k) {
    small_tiles.push_back(panel(0.2 * (k % 8), 0.2 * (k / 8), 3.0, 0.0, 0.2, 0.2));
  }
  EXPECT_THAT(joined_openings(small_tiles), SizeIs(1)) << "narrow, and side by side";
}

}  // namespace
}  // namespace calc::joined_openings_test
