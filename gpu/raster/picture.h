#pragma once
// Draws by rasterisation: surfaces that carry a value, and lines, faces and dots over them.

#include "gpu/device/device_thread.h"
#include "gpu/raster/camera.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

// Colour components and opacity, 0 to 1.
struct PictureLine {
  glm::dvec3 from_m, to_m;
  glm::vec4 colour;
  double width_px = 1.0;
  double hidden_share = 0.0;  // opacity behind surfaces, as a share of that before them
};
struct PictureFace {
  std::array<glm::dvec3, 3> corner_m;
  glm::vec4 colour;
};
// A disc that faces the eye, with a rim.
struct PictureDot {
  glm::dvec3 centre_m;
  double radius_px;
  glm::vec4 colour, rim;
};

struct PictureScene {
  std::vector<glm::vec3> position_m;  // local
  std::vector<float> value;           // [position], >= 0
  std::vector<glm::uvec3> triangle;
  std::vector<PictureFace> faces;  // over the surfaces, in this order, then lines, then dots
  std::vector<PictureLine> lines;
  std::vector<PictureDot> dots;
  double lift_m = 0.0;  // faces, lines and dots are drawn so much nearer to the eye
};

// A picture with rows from the top.
struct Picture {
  static constexpr float kNothing = -1.0f;

  int width = 0, height = 0;
  std::vector<float> value;         // of the surface seen; kNothing where there is none
  std::vector<std::uint8_t> cover;  // RGBA of what is drawn over it, premultiplied
};

// Draws a picture. width: pixels; the height follows from the camera. Sizes in pixels are those of
// this picture. The same device gives the same bits. recycled: an old picture, for its memory.
// Throws calc::BackendFailure; the device may be used again, unless it is lost.
Picture draw_picture(DeviceThread& thread, const PictureScene& scene, const Camera& camera,
                     int width, Picture recycled = {});

// Returns the picture's height, at least 1.
int height_of(const Camera& camera, int width);

}  // namespace gpu
