#pragma once
// Lines that show a room that is known by its surfaces alone.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace report {

struct SurfaceLine {
  glm::dvec3 from_m, to_m;  // world
};

// Where surfaces of the bodies bend by more than 26 degrees, or end: sides of triangles that no
// other one shares, or one that looks elsewhere; straight runs of them are one line. Neighbours are
// known by the places of their corners, also those of another body, since files repeat vertices.
// Housings of luminaires are left out. In the order of their ends: x, then y, then z; the same for
// any order of bodies, triangles and vertices.
std::vector<SurfaceLine> surface_lines(const std::vector<calc::Body>& bodies);

}  // namespace report
