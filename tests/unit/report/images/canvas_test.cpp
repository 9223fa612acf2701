#include "report/images/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace report::canvas_test {
namespace {

std::array<int, 4> at(const Raster& raster, int x, int y) {
  const auto i = 4 * static_cast<std::size_t>(y * raster.width + x);
  return {raster.rgba[i], raster.rgba[i + 1], raster.rgba[i + 2], raster.rgba[i + 3]};
}
constexpr std::array<int, 4> kWhite{255, 255, 255, 255}, kBlack{0, 0, 0, 255};

TEST(Canvas, LinesHaveSmoothEdges) {
  Canvas canvas(20, 20);
  canvas.line(std::vector<glm::dvec2>{{2, 10}, {18, 10}}, 3.0, {0, 0, 0});
  EXPECT_EQ(at(canvas.raster(), 10, 10), kBlack);
  EXPECT_EQ(at(canvas.raster(), 10, 13), kWhite);
  // Half of a pixel lies within a line from 8.5 to 11.5.
  const int edge = at(canvas.raster(), 10, 8)[0];
  EXPECT_NEAR(edge, 128, 2);
}

// Along and across a line that leans: as far from it as one that lies.
TEST(Canvas, LeaningLinesAreWhole) {
  Canvas canvas(40, 40);
  canvas.line(std::vector<glm::dvec2>{{36, 4}, {4, 36}}, 4.0, {0, 0, 0});
  for (int k = 6; k < 34; ++k) {  // away from the ends, which are round
    EXPECT_EQ(at(canvas.raster(), k, 39 - k), kBlack) << k;
    EXPECT_EQ(at(canvas.raster(), k - 2, 39 - k), kBlack) << k;
    EXPECT_EQ(at(canvas.raster(), k - 4, 39 - k), kWhite) << k;
  }
}

TEST(Canvas, LeavesOutWhatIsNoPlace) {
  Canvas canvas(4, 4);
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300})
    canvas.line(std::vector<glm::dvec2>{{x, x}, {x, -x}}, 1.0, {0, 0, 0});
  EXPECT_EQ(at(canvas.raster(), 2, 2), kWhite);
}

// What is painted stays as it is when more is.
TEST(Canvas, PaintsOnlyWhatIsNew) {
  Canvas canvas(20, 20);
  canvas.line(std::vector<glm::dvec2>{{2, 3}, {18, 3}}, 2.0, {255, 0, 0});
  canvas.line(std::vector<glm::dvec2>{{2, 15}, {18, 15}}, 2.0, {0, 0, 255});
  EXPECT_EQ(at(canvas.raster(), 10, 3), (std::array<int, 4>{255, 0, 0, 255}));
  EXPECT_EQ(at(canvas.raster(), 10, 15), (std::array<int, 4>{0, 0, 255, 255}));
  EXPECT_EQ(at(canvas.raster(), 10, 9), kWhite);
}

TEST(Canvas, PutsTransparentPicturesOnWhite) {
  Canvas canvas(3, 2);
  canvas.put({2, 1, {10, 20, 30, 255, 0, 0, 0, 51}}, 1, 1);
  EXPECT_EQ(at(canvas.raster(), 0, 0), kWhite);
  EXPECT_EQ(at(canvas.raster(), 1, 1), (std::array<int, 4>{10, 20, 30, 255}));
  EXPECT_EQ(at(canvas.raster(), 2, 1), (std::array<int, 4>{204, 204, 204, 255}));
}

TEST(Canvas, WordsBeginEndOrStandInTheMiddle) {
  const auto ink = [](TextAnchor anchor) {
    Canvas canvas(200, 40);
    canvas.write("HH", {100, 30}, 30, anchor, {0, 0, 0});
    int first = 200, last = -1;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 200; ++x) {
        if (at(canvas.raster(), x, y)[0] > 128) continue;
        first = std::min(first, x);
        last = std::max(last, x);
      }
    }
    return std::array<int, 2>{first, last};
  };
  EXPECT_NEAR(ink(TextAnchor::start)[0], 100, 2);
  EXPECT_NEAR(ink(TextAnchor::end)[1], 100, 2);
  const auto middle = ink(TextAnchor::middle);
  EXPECT_NEAR(middle[0] + middle[1], 200, 3);
  // What is outside is left out.
  Canvas canvas(10, 10);
  canvas.write("WWWW", {-5, 300}, 30, TextAnchor::start, {0, 0, 0});
  EXPECT_EQ(canvas.raster().rgba.size(), 400u);
}

}  // namespace
}  // namespace report::canvas_test
