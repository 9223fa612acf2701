#pragma once
// Which surfaces a picture of a room from outside shows, and which are in its way.

#include "calc/radiosity/sampling/rays.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace calc {

// A triangle's side that faces the eye.
struct SurfaceSide {
  std::uint32_t triangle;
  bool is_flipped;   // its corners run clockwise as seen from the eye
  glm::vec3 normal;  // unit, towards the eye
  bool operator==(const SurfaceSide&) const = default;
};

struct Cutaway {
  std::vector<SurfaceSide> shown;
  std::vector<std::uint32_t> removed;  // triangles
};

// opens_room: leaves out surfaces that turn the outside of a room to the eye, so that it can be
// looked into: those from whose far side rays meet surfaces more often, by 40 % of them or more,
// than from the near side.
Cutaway cut_away(const Tracer& tracer, const glm::dvec3& eye_m, bool opens_room);

// What is left of both sides of all triangles when all are looked at, from wherever they face: of
// models that are turned about. A side that cut_away() would remove is not among them.
std::vector<SurfaceSide> sides_from_everywhere(const Tracer& tracer, bool opens_room);

}  // namespace calc
