#pragma once
// Chooses the surfaces that a picture of a room from outside shows, and those to remove.

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

// Returns the sides that face the eye. opens_room: removes surfaces whose side outside the room
// faces the eye, to show its inside: those from whose far side rays meet surfaces more often, by 40
// % of them or more, than from the near side.
Cutaway cut_away(const Tracer& tracer, const glm::dvec3& eye_m, bool opens_room);

// Returns the sides of all triangles that remain in models that can be turned, seen from wherever
// they face; without sides that cut_away() would remove.
std::vector<SurfaceSide> sides_from_everywhere(const Tracer& tracer, bool opens_room);

}  // namespace calc
