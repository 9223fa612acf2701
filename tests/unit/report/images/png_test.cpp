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

}  // namespace
}  // namespace report::png_test
