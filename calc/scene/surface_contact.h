#pragma once
// Finds the sides on which points in surfaces may be meant to be.

#include "calc/scene/near_triangles.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// The radius around a point that surface_contact() examines, in ray offsets.
inline constexpr double kContactReach = 24.0;

// The contact of a point in a surface, whose view is ambiguous.
struct SurfaceContact {
  const Body* body = nullptr;  // that it lies in; of several the last of the space; null: none

  // The sides into which surfaces divide the places around the point, each as a shift from it to
  // the nearest place from which every ray meets those surfaces. `has_room` false: the side is too
  // narrow for such a place; the shift is then only its direction.
  struct Side {
    glm::dvec3 shift_m{0.0};
    bool has_room = true;
  };
  std::vector<Side> sides;
};

// Returns the contact of a point. A plane that looks away from the surface it is in has none: only
// surfaces that rise in front of it count. Any other receiver has, and belongs to the side of
// `front` if all surfaces there are across it. Sides are distinguished to about a twentieth of a
// turn. front: unit; of a plane its direction. near: made for radii of kContactReach offsets at
// least.
//
// The value on a side is the limit of values along the straight way that leads farthest from the
// surfaces: off a wall its perpendicular, in a corner the middle.
SurfaceContact surface_contact(const NearTriangles& near, const glm::dvec3& point_m,
                               const glm::dvec3& front, ReceiverKernel kernel, double ray_offset_m);

}  // namespace calc
