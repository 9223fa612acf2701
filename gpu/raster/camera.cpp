#include "gpu/raster/camera.h"

#include "calc/base/elementary.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gpu {
namespace {

constexpr double kMargin = 0.03;     // of the longer side, on every side
constexpr double kElevation = 0.72;  // rad
constexpr double kAside = 0.42;      // rad, from straight across the longer side
constexpr double kSight = 0.7;       // rad, angle of sight before the picture is fitted
constexpr double kDistance = 2.4;    // diagonals of the box, from its middle

std::array<glm::dvec3, 8> corners_of(const RoomBox& box) {
  std::array<glm::dvec3, 8> result;
  for (std::size_t k = 0; k < 8; ++k) {
    result[k] = {(k & 1u) != 0 ? box.high_m.x : box.low_m.x,
                 (k & 2u) != 0 ? box.high_m.y : box.low_m.y,
                 (k & 4u) != 0 ? box.high_m.z : box.low_m.z};
  }
  return result;
}

// Scales and shifts what the matrix shows so that the box just fills the picture.
void fit(Camera& camera, const RoomBox& box) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& corner : corners_of(box)) {
    const glm::dvec3 p = camera.project(corner);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 size = glm::max(high - low, glm::dvec3(1e-9));
  const glm::dvec3 middle = 0.5 * (low + high);
  const glm::dvec2 margin(2.0 * kMargin * std::max(size.x, size.y));
  const glm::dvec2 whole = glm::dvec2(size) + margin;
  camera.aspect *= whole.x / whole.y;
  const glm::dmat4 scale =
      glm::scale(glm::dmat4(1.0), glm::dvec3(2.0 / whole.x, 2.0 / whole.y, 1.9 / size.z));
  camera.clip_from_local =
      scale * glm::translate(glm::dmat4(1.0), -middle) * camera.clip_from_local;
}

double diagonal_m(const RoomBox& box) {
  return std::max(glm::length(box.high_m - box.low_m), 1e-6);
}

}  // namespace

Camera corner_camera(const RoomBox& box) {
  const glm::dvec3 size = box.high_m - box.low_m;
  const double turn = size.x >= size.y ? 0.0 : 1.5707963267948966;
  const double around = turn - 1.5707963267948966 - kAside;  // of the eye, from the middle
  const glm::dvec3 out(calc::cos(kElevation) * calc::cos(around),
                       calc::cos(kElevation) * calc::sin(around), calc::sin(kElevation));
  const glm::dvec3 middle = 0.5 * (box.low_m + box.high_m);
  const double distance = kDistance * diagonal_m(box);
  Camera camera;
  camera.eye_m = middle + distance * out;
  const double near = 0.5 * distance, reach = near * calc::tan(0.5 * kSight);
  camera.clip_from_local = glm::frustum(-reach, reach, -reach, reach, near, 1.5 * distance) *
                           glm::lookAt(camera.eye_m, middle, glm::dvec3(0, 0, 1));
  fit(camera, box);
  return camera;
}

Camera plan_camera(const RoomBox& box) {
  const glm::dvec3 middle = 0.5 * (box.low_m + box.high_m);
  const double d = diagonal_m(box);
  Camera camera;
  camera.eye_m = middle + glm::dvec3(0, 0, 1e5 * d);
  camera.clip_from_local =
      glm::ortho(-d, d, -d, d, -d, d) * glm::translate(glm::dmat4(1.0), -middle);
  fit(camera, box);
  return camera;
}

}  // namespace gpu
