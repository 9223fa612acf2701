#pragma once
// The view from which a picture of a room is taken.

#include <glm/glm.hpp>

namespace gpu {

// A box in local coordinates, z up.
struct RoomBox {
  glm::dvec3 low_m{0.0}, high_m{0.0};
};

struct Camera {
  glm::dmat4 clip_from_local{1.0};
  glm::dvec3 eye_m{0.0};  // far outside the box; nothing is behind it
  double aspect = 1.0;    // width over height

  // Returns the place in the picture: x to the right, y up, both -1 to 1; z is depth, -1 nearest.
  glm::dvec3 project(const glm::dvec3& p_m) const {
    const glm::dvec4 clip = clip_from_local * glm::dvec4(p_m, 1.0);
    return glm::dvec3(clip) / clip.w;
  }
  // Returns a point moved towards the eye, so that lines are off the surfaces they are drawn on.
  glm::dvec3 nearer(const glm::dvec3& p_m, double distance_m) const {
    return p_m + glm::normalize(eye_m - p_m) * distance_m;
  }
};

// Returns a view from above one corner, across the longer side; the box's horizontal axis is to the
// right. The box fills the picture up to a small margin.
Camera corner_camera(const RoomBox& box);

// Returns a view from above without perspective: x to the right, y up, as in a plan.
Camera plan_camera(const RoomBox& box);

}  // namespace gpu
