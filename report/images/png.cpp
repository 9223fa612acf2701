#include "report/images/png.h"

#include "report/images/room_picture.h"

#include <png.h>

#include <cstdint>
#include <stdexcept>

namespace report {
namespace {

constexpr int kWantedPixels = 1024;

[[noreturn]] void fail(const png_image& image) {
  throw std::runtime_error(std::string("cannot encode PNG: ") + image.message);
}

}  // namespace

std::string encode_png(const Raster& raster) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(raster.width);
  image.height = static_cast<png_uint_32>(raster.height);
  image.format = PNG_FORMAT_RGBA;
  // Without filters: areas of one colour pack as well, in a fifth of the time.
  image.flags = PNG_IMAGE_FLAG_FAST;
  // Asking for the size first would pack the picture twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, raster.rgba.data(), 0, nullptr) ==
      0) {
    fail(image);
  }
  bytes.resize(size);
  return bytes;
}

std::string render_heatmap_png(const PlanePart& plane, const ColourScale& scale) {
  return encode_png(with_legend(plane_raster(plane, scale, pixels_per_cell(plane, kWantedPixels)),
                                scale, calc::unit_of(plane.derived)));
}

}  // namespace report
