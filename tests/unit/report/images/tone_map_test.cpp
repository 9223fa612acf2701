#include "report/images/tone_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>

namespace report::tone_map_test {
namespace {

TEST(ToneMap, AverageIsThatOfLogarithmsOfWhatIsThere) {
  const std::array<float, 4> values{10.0F, -1.0F, 1000.0F, -1.0F};
  EXPECT_NEAR(log_average(values), 100.0, 1e-6);
  using Limits = std::numeric_limits<float>;
  const std::array<float, 4> wild{10.0F, Limits::quiet_NaN(), 1000.0F, Limits::infinity()};
  EXPECT_NEAR(log_average(wild), 100.0, 1e-6);
  const std::array<float, 2> nothing{-1.0F, -1.0F};
  EXPECT_EQ(log_average(nothing), 0.0);
  const std::array<float, 2> black{0.0F, 1000.0F};  // no infinity
  EXPECT_NEAR(log_average(black), 1.0, 1e-6);
}

TEST(ToneMap, GoesFromBlackToWarmWhite) {
  EXPECT_EQ(toned(0.0, 50.0).r, 0);
  EXPECT_EQ(toned(16.0 * 50.0, 50.0).r, 255);
  EXPECT_LT(toned(15.0 * 50.0, 50.0).r, 255);
  EXPECT_EQ(toned(1e9, 50.0).r, 255);
  EXPECT_LT(toned(1e9, 50.0).b, 245);
  for (const double bright : {1e200, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(toned(bright, 50.0).b, toned(1e9, 50.0).b) << bright;
  // The average is a middle grey, however bright it is.
  for (const double average : {0.01, 50.0, 1e5}) {
    EXPECT_GT(toned(average, average).g, 110) << average;
    EXPECT_LT(toned(average, average).g, 160) << average;
  }
  int before = -1;
  for (int k = 0; k <= 160; ++k) {
    const int now = toned(0.1 * k * 50.0, 50.0).r;
    EXPECT_GE(now, before);
    before = now;
  }
}

TEST(ToneMap, IsBlackWithoutLight) {
  EXPECT_EQ(toned(0.0, 0.0).r, 0);
  EXPECT_GT(tone_palette(0.0).step, 0.0F);
}

// A step of the palette is at most a few shades, and only where it is dark.
TEST(ToneMap, PaletteHasSmallSteps) {
  const Palette palette = tone_palette(50.0);
  EXPECT_EQ(palette.colour.front().r, 0);
  EXPECT_EQ(palette.colour.back().r, 255);
  for (std::size_t k = 1; k < palette.colour.size(); ++k) {
    EXPECT_LE(palette.colour[k].r - palette.colour[k - 1].r, 6) << k;
  }
  const auto at = static_cast<std::size_t>(50.0F / palette.step);
  EXPECT_NEAR(palette.colour[at].r, toned(50.0, 50.0).r, 1);
}

}  // namespace
}  // namespace report::tone_map_test
