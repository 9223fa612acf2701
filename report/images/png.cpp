#include "report/images/png.h"

#include "report/images/room_picture.h"

#include <png.h>
#include <glm/glm.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace report {
namespace {

constexpr int kWantedPixels = 1024;

[[noreturn]] void fail(const png_image& image) {
  throw std::runtime_error(std::string("cannot encode PNG: ") + image.message);
}

// A results file may hold any number of corners, and each of their lines takes time.
bool are_drawable(const PlanePart& plane) {
  constexpr std::size_t kMostCorners = 500;
  std::size_t corners = plane.outline_m.size();
  for (const std::vector<glm::dvec2>& hole : plane.holes_m) corners += hole.size();
  return !plane.outline_m.empty() && corners <= kMostCorners;
}

// In the pixels of plane_raster(). The cells of a route are drawn in a row, whatever its bends: its
// outline is that of the picture, and so is that of a plane whose own outline is not there or has
// too many corners.
std::vector<std::vector<glm::dvec2>> plane_outlines(const PlanePart& plane, int pixels_per_cell) {
  const calc::SensorGrid& grid = plane.grid;
  const glm::dvec2 size_px(grid.columns * pixels_per_cell, grid.rows * pixels_per_cell);
  if (grid.route || !are_drawable(plane)) {
    return {{{0.0, 0.0}, {size_px.x, 0.0}, size_px, {0.0, size_px.y}}};
  }
  std::vector<std::vector<glm::dvec2>> outlines{plane.outline_m};
  outlines.insert(outlines.end(), plane.holes_m.begin(), plane.holes_m.end());
  for (std::vector<glm::dvec2>& outline : outlines) {
    for (glm::dvec2& corner : outline) {
      corner = {pixels_per_cell * corner.x / grid.spacing_u_m,
                size_px.y - pixels_per_cell * corner.y / grid.spacing_v_m};
    }
  }
  return outlines;
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

std::string render_heatmap_png(const PlanePart& plane, const ColourScale& scale,
                               const std::string& title, const std::string& note) {
  const int cell_px = pixels_per_cell(plane, kWantedPixels);
  return encode_png(
      with_legend(plane_raster(plane, scale, cell_px), scale,
                  {title, note, calc::unit_of(plane.derived), plane_outlines(plane, cell_px)}));
}

}  // namespace report
