#pragma once
// Points that lie in surfaces: the sides that they may be meant to stand on.

#include "calc/scene/near_triangles.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// How far around a point surface_contact() looks, in ray offsets.
inline constexpr double kContactReach = 24.0;

// Of a point that lies in a surface, so that what it sees is not clear.
struct SurfaceContact {
  const Body* body = nullptr;  // that it lies in; of several the last of the space; null: none

  // Where surfaces divide the places around the point, one place on each side, as a shift from the
  // point: the nearest one from which every ray meets those surfaces. `has_room` false: the side is
  // so narrow that there is none; the shift then only says where the side is.
  struct Side {
    glm::dvec3 shift_m{0.0};
    bool has_room = true;
  };
  std::vector<Side> sides;
};

// A plane that looks away from the surface it lies in is not in contact: only what rises in front
// of it counts. Any other receiver is, and stands on the side that `front` shows if all surfaces
// there lie across it. Sides are told apart to about a twentieth of a turn. front: unit; of a plane
// the way it looks. near: made for radii of kContactReach offsets at least.
//
// The value on a side is the limit of values along the straight way that leads farthest from the
// surfaces: off a wall its perpendicular, in a corner the middle.
SurfaceContact surface_contact(const NearTriangles& near, const glm::dvec3& point_m,
                               const glm::dvec3& front, ReceiverKernel kernel, double ray_offset_m);

}  // namespace calc
