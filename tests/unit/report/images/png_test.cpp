#include "report/images/png.h"

#include "tests/support/sample_document.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace report::png_test {
namespace {

TEST(Png, ReadsBackTheSamePixels) {
  const Raster raster{2, 1, {10, 20, 30, 255, 0, 0, 0, 0}};
  const std::string bytes = encode_png(raster);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  image.format = PNG_FORMAT_RGBA;
  EXPECT_EQ(image.width, 2U);
  EXPECT_EQ(image.height, 1U);
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, raster.rgba);
}

TEST(Png, HeatMapIsScaledByAWholeFactor) {
  const PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  const std::string bytes = render_heatmap_png(plane, scale_of(plane));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(image.width, 1024U + 48U);
  EXPECT_GT(image.height, 512U + 48U);  // with the legend
  png_image_free(&image);
  EXPECT_EQ(bytes, render_heatmap_png(plane, scale_of(plane)));
}

TEST(Png, EmptyRasterIsRefused) { EXPECT_THROW(encode_png(Raster{}), std::runtime_error); }

// The frame of the picture stands for an outline that would take too long.
TEST(Png, AnOutlineOfVeryManyCornersIsNotDrawn) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  plane.outline_m.clear();
  const std::string frame = render_heatmap_png(plane, scale_of(plane));
  plane.outline_m = {{0.5, 0.5}, {1.0, 0.5}, {1.0, 1.0}};
  EXPECT_NE(render_heatmap_png(plane, scale_of(plane)), frame);
  plane.holes_m.assign(1, std::vector<glm::dvec2>(498, {0.6, 0.6}));
  EXPECT_EQ(render_heatmap_png(plane, scale_of(plane)), frame);
}

}  // namespace
}  // namespace report::png_test
