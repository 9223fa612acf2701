#include "report/images/heatmap.h"

#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace report::heatmap_test {
namespace {

TEST(Cividis, EndsAndMiddle) {
  EXPECT_EQ(hex_colour(cividis(0)), "#00204d");
  EXPECT_EQ(hex_colour(cividis(1)), "#ffea46");
  EXPECT_EQ(hex_colour(cividis(-3)), "#00204d");
  EXPECT_EQ(hex_colour(cividis(7)), "#ffea46");
  EXPECT_EQ(hex_colour(cividis(4.0 / 9.0)), "#707173");
}

TEST(Cividis, GetsLighterAllTheWay) {
  const auto grey = [](double t) {
    const Rgb c = cividis(t);
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
  };
  for (int i = 0; i < 100; ++i) EXPECT_LT(grey(i / 100.0), grey((i + 1) / 100.0)) << i;
}

TEST(Cividis, TextColourFollowsTheBackground) {
  EXPECT_FALSE(needs_dark_text(cividis(0)));
  EXPECT_TRUE(needs_dark_text(cividis(1)));
}

TEST(FalseColour, GoesFromBlueToMagenta) {
  EXPECT_EQ(hex_colour(false_colour(0)), "#1428b4");
  EXPECT_EQ(hex_colour(false_colour(0.6)), "#ffe600");
  EXPECT_EQ(hex_colour(false_colour(1)), "#dc00c8");
  EXPECT_EQ(hex_colour(false_colour(7)), "#dc00c8");
}

// Of values on cells: 4.5 is the AA of WCAG 2.2.
TEST(ColourMap, NumbersCanBeReadOnEveryColour) {
  const auto linear = [](int channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  for (const ColourMap map : {ColourMap::cividis, ColourMap::false_colour}) {
    for (int bands = 1; bands <= 12; ++bands) {
      const ColourScale scale{0.0, 1.0, bands, {}, map};
      for (int band = 0; band < bands; ++band) {
        const Rgb c = band_colour(scale, band);
        const double luminance = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
        const double contrast =
            needs_dark_text(c) ? (luminance + 0.05) / 0.05 : 1.05 / (luminance + 0.05);
        EXPECT_GE(contrast, 4.5) << hex_colour(c);
      }
    }
  }
}

TEST(ColourMap, NeighboursDiffer) {
  for (const ColourMap map : {ColourMap::cividis, ColourMap::false_colour}) {
    const ColourScale scale{0.0, 1.0, 12, {}, map};
    for (int band = 1; band < 12; ++band) {
      const Rgb a = band_colour(scale, band - 1), b = band_colour(scale, band);
      EXPECT_GT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 20) << band;
    }
  }
}

TEST(ColourScale, HasRoundStepsThatCoverTheValues) {
  const ColourScale scale = make_colour_scale(214.4, 773.2);
  EXPECT_DOUBLE_EQ(scale.step, 100);
  EXPECT_DOUBLE_EQ(scale.low, 200);
  EXPECT_DOUBLE_EQ(scale.high(), 800);
}

TEST(ColourScale, BandsIncludeTheirLowerLimit) {
  const ColourScale scale = make_colour_scale(200, 800);
  EXPECT_EQ(band_of(scale, 299.9), 0);
  EXPECT_EQ(band_of(scale, 300), 1);
  EXPECT_EQ(band_of(scale, 800), scale.bands - 1);
  EXPECT_EQ(band_of(scale, 0), 0);
  EXPECT_EQ(band_of(scale, 1e9), scale.bands - 1);
}

TEST(ColourScale, EvenFieldsAreNotPaintedAsStructure) {
  const ColourScale scale = make_colour_scale(500.0, 500.4);
  EXPECT_GE(scale.step, 5);
  EXPECT_EQ(band_of(scale, 500.0), band_of(scale, 500.4));
}

TEST(ColourScale, DarknessAndTinyValuesHaveAScale) {
  EXPECT_GE(make_colour_scale(0, 0).bands, 1);
  const ColourScale scale = make_colour_scale(0.0001, 0.0009);
  EXPECT_LE(scale.low, 0.0001);
  EXPECT_GE(scale.high(), 0.0009 - 1e-12);
  EXPECT_LE(scale.bands, 12);
}

TEST(ClassScale, FollowsTheSeriesAndCoversTheValues) {
  EXPECT_THAT(make_class_scale(80, 940).classes,
              testing::ElementsAre(75, 100, 150, 200, 300, 500, 750, 1000));
  EXPECT_THAT(make_class_scale(100, 300).classes, testing::ElementsAre(100, 150, 200, 300));
  EXPECT_THAT(make_class_scale(500, 500).classes, testing::ElementsAre(500, 750));
  EXPECT_THAT(make_class_scale(110, 700, ClassSeries::fine).classes,
              testing::ElementsAre(100, 120, 150, 200, 250, 300, 400, 500, 600, 750));
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{
           {0, 0.004}, {0, 7}, {0.3, 1200}, {1e-9, 1e-9}, {3, 3e7}, {0.07, 0.08}, {0, 1e12}}) {
    const ColourScale scale = make_class_scale(low, high);
    EXPECT_LE(scale.low, low) << low << " to " << high;
    EXPECT_GE(scale.high(), high) << low << " to " << high;
    EXPECT_LE(scale.bands, 12) << low << " to " << high;
    for (int i = 0; i < scale.bands; ++i) EXPECT_LT(scale.border(i), scale.border(i + 1));
  }
}

TEST(ClassScale, BandsIncludeTheirLowerLimit) {
  const ColourScale scale = make_class_scale(100, 900);
  for (int band = 0; band < scale.bands; ++band) {
    EXPECT_EQ(band_of(scale, scale.border(band)), band);
    EXPECT_EQ(band_of(scale, 0.5 * (scale.border(band) + scale.border(band + 1))), band);
    EXPECT_EQ(band_of(scale, scale.border(band) - 0.01), std::max(0, band - 1));
  }
  EXPECT_EQ(band_of(scale, 0), 0);
  EXPECT_EQ(band_of(scale, 1e9), scale.bands - 1);
}

// Neighbours are told apart in grey print: each class is as much lighter as the next one.
TEST(ClassScale, ColoursHaveEqualDistance) {
  const ColourScale scale = make_class_scale(20, 900);
  const auto grey = [&](int band) {
    const Rgb c = band_colour(scale, band);
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
  };
  const double mean = (grey(scale.bands - 1) - grey(0)) / (scale.bands - 1);
  for (int i = 0; i + 1 < scale.bands; ++i) {
    EXPECT_GT(grey(i + 1) - grey(i), 0.5 * mean) << i;
    EXPECT_LT(grey(i + 1) - grey(i), 1.5 * mean) << i;
  }
}

TEST(Raster, LargestRowIsOnTopAndGapsAreClear) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  plane.grid.rows = 2;
  plane.points[1].row = 1;  // now (0, 0) and (1, 1)
  const Raster raster = plane_raster(plane, scale_of(plane), 3);
  ASSERT_EQ(raster.width, 6);
  ASSERT_EQ(raster.height, 6);
  const auto alpha = [&](int x, int y) {
    return raster.rgba[static_cast<std::size_t>((y * 6 + x) * 4 + 3)];
  };
  EXPECT_EQ(alpha(0, 0), 0);
  EXPECT_EQ(alpha(3, 0), 255);
  EXPECT_EQ(alpha(2, 5), 255);
  EXPECT_EQ(alpha(5, 5), 0);
  const std::size_t bright = static_cast<std::size_t>(5 * 6 * 4), dark = 3 * 4;
  EXPECT_GT(raster.rgba[bright], raster.rgba[dark]);
}

TEST(Raster, PointListsHaveNoCells) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  EXPECT_TRUE(has_cells(plane));
  plane.grid.columns = plane.grid.rows = 0;
  EXPECT_FALSE(has_cells(plane));
}

}  // namespace
}  // namespace report::heatmap_test
