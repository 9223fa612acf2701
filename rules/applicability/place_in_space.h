#pragma once
// Where a plane lies in its space: what stands below it and behind it.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace rules {

// What is laid a little off a surface, so as not to lie in it, counts as lying on it.
inline constexpr double kLift_m = 0.05;

// Which way something looks that need not be exactly level or upright: up to 15 degrees. normal:
// unit.
bool looks_up(const glm::dvec3& normal);
bool looks_down(const glm::dvec3& normal);
bool looks_sideways(const glm::dvec3& normal);

// In metres. The floor is a room's own; of a room from a building file the lowest corner of its
// surfaces; in the open space the highest surface below the place, or z = 0 where there is none.
double height_above_floor_m(const glm::dvec3& place, const calc::Space& space);

// Of a luminaire above what people may walk on: the highest surface below it or place of the plane,
// and the floor or the lowest of these. Both of the same floor are one height.
struct MountingHeight {
  double least_m, most_m;
};
// Of all luminaires of the space, in their order. Looks at every surface for each of them.
std::vector<MountingHeight> mounting_heights_m(const calc::Space& space,
                                               const calc::CalcPlane& plane);

// calc::width_up_to() of a room; of one from a building file, if its outline is known. Else, and
// outdoors, most_m.
double room_width_m(const calc::Space& space, double most_m);

// Lowest and highest place of a plane above the floor, as before. Of a route it is what it states:
// its points follow the floor.
std::pair<double, double> heights_above_floor_m(const calc::CalcPlane& plane,
                                                const calc::Space& space);

std::array<glm::dvec3, 3> corners_of(const calc::Body& body, const glm::uvec3& triangle);

// Whether the id of a body ends so, before its digits: ".wall" of "r.wall2".
bool is_part(std::string_view id, std::string_view part);

// Whether every place lies on a surface of a body whose id ends so (".ceiling", ".wall2": before
// the digits), within kLift_m, and looks the way it does or the other one, up to 15 degrees. Where
// walls have no names, of any body.
bool lies_on(const calc::CalcPlane& plane, const calc::Space& space, std::string_view part);

// Whether every place lies on a surface of some body that leans as it does, within half a degree:
// planes along ramps, floors that slope, boards. Up to kOnSlope_m off it.
inline constexpr double kOnSlope_m = 0.3;
bool lies_along(const calc::CalcPlane& plane, const calc::Space& space);

// The body of which a surface lies before every place of the plane, alike and within kLift_m, so
// that no light meets the plane: a facade that the plane of a window was laid into. Null: there is
// none.
const calc::Body* body_before(const calc::CalcPlane& plane, const calc::Space& space);

}  // namespace rules
