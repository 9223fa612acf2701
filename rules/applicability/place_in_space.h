#pragma once
// Where a plane lies in its space: the surfaces below it and behind it.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace rules {

// Largest distance at which a plane counts as lying on a surface: planes are drawn slightly off
// surfaces so as not to lie in them.
inline constexpr double kLift_m = 0.05;

// Return the direction that something faces, within 15 degrees of level or upright. normal: unit.
bool looks_up(const glm::dvec3& normal);
bool looks_down(const glm::dvec3& normal);
bool looks_sideways(const glm::dvec3& normal);

// Returns the height in metres. The floor is a room's own; in a room from a building file the
// lowest corner of its surfaces; in the open space the highest surface below the place, or z = 0 if
// there is none.
double height_above_floor_m(const glm::dvec3& place, const calc::Space& space);

// Height of a luminaire above places where people may walk: the highest surface below it or place
// of the plane, and the floor or the lowest of these. On one floor both heights are equal.
struct MountingHeight {
  double least_m, most_m;
};
// Returns the heights of all luminaires of the space, in their order. Tests every surface for each.
std::vector<MountingHeight> mounting_heights_m(const calc::Space& space,
                                               const calc::CalcPlane& plane);

// Returns calc::width_up_to() of a room; for a room from a building file only if its outline is
// known. Otherwise, and outdoors, returns most_m.
double room_width_m(const calc::Space& space, double most_m);

// Returns the lowest and highest place of a plane above the floor, as before. For a route they are
// the stated height: its points follow the floor.
std::pair<double, double> heights_above_floor_m(const calc::CalcPlane& plane,
                                                const calc::Space& space);

std::array<glm::dvec3, 3> corners_of(const calc::Body& body, const glm::uvec3& triangle);

// Returns whether the id of a body ends with `part` before its digits: ".wall" in "r.wall2".
bool is_part(std::string_view id, std::string_view part);

// Returns whether every place lies within kLift_m of a surface that faces the same or the opposite
// way, up to 15 degrees. The id of its body must end with `part` (".ceiling", ".wall2": before the
// digits); where walls have no names, any body counts.
bool lies_on(const calc::CalcPlane& plane, const calc::Space& space, std::string_view part);

// Returns whether every place lies on a surface of a body with the same slope, within half a
// degree: planes along ramps, sloping floors, boards. At most kOnSlope_m off it.
inline constexpr double kOnSlope_m = 0.3;
bool lies_along(const calc::CalcPlane& plane, const calc::Space& space);

// Returns the body with a surface before every place of the plane, parallel and within kLift_m, so
// that no light reaches the plane: for example a facade around the plane of a window. Null: there
// is none.
const calc::Body* body_before(const calc::CalcPlane& plane, const calc::Space& space);

}  // namespace rules
