#include "report/images/heatmap.h"

#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace report {
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
}  // namespace report
