#pragma once
// How much of a wall or of the ceiling a plane stands for.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace rules {

// A flat wall or ceiling of a room.
struct RoomSurface {
  std::string id;                     // of its body: "r.wall2"
  glm::dvec3 origin_m, u, v;          // orthonormal axes
  std::vector<glm::dvec2> outline_m;  // in (u, v)
};

// Those whose body's id ends with the part, before its digits: ".wall", ".ceiling". In the order of
// the bodies. Empty for spaces that do not know their walls.
std::vector<RoomSurface> surfaces_of(const calc::Space& space, std::string_view part);

// Whether anything is left of the surface without a strip along its edges, in metres.
bool has_inside(const RoomSurface& surface, double strip_m);

struct CoveredSurface {
  std::string id;
  double area_m2 = 0.0;  // of the surface, without the strip along its edges
  double share = 0.0;    // of that, [0, 1]: covered by the area without its own strip
};

// Of the surfaces that the area lies on (within kLift_m, on either side) as far as something is
// left of them without a strip of strip_m along their edges. own_strip_m: along the outline of the
// area, which does not count; its holes do not, either. Measured at some thousand places of every
// surface.
std::vector<CoveredSurface> covered_surfaces(const calc::PlanarArea& area, double own_strip_m,
                                             const std::vector<RoomSurface>& surfaces,
                                             double strip_m);

}  // namespace rules
