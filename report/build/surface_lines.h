#pragma once
// Lines for plans of a room that only has surfaces.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace report {

struct SurfaceLine {
  glm::dvec3 from_m, to_m;  // world
};

// Returns lines where surfaces of the bodies bend by more than 26 degrees, or end: sides of
// triangles without a neighbour, or with one in another direction; straight runs of them are one
// line. Neighbours are found by the places of their corners, also across bodies, because files
// repeat vertices. Housings of luminaires are omitted. In the order of their ends: x, then y, then
// z; the same for any order of bodies, triangles and vertices.
std::vector<SurfaceLine> surface_lines(const std::vector<calc::Body>& bodies);

}  // namespace report
