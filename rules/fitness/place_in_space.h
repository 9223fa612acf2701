#pragma once
// Where a plane lies in its space: what stands below it, behind it, before it.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <string_view>
#include <utility>
#include <vector>

namespace rules {

// The corners of an area or of the line of a route, or the points of a list; world coordinates.
std::vector<glm::dvec3> places_of(const calc::CalcPlane& plane);
// One for each place; of an area all are alike. Unit.
std::vector<glm::dvec3> normals_of(const calc::CalcPlane& plane);

// Lowest and highest place above the floor, in metres. The floor is a room's own; of a room from a
// building file the lowest corner of its surfaces; in the open space the highest surface below the
// place, or z = 0 where there is none. Of a route it is what it states: its points follow the
// floor.
std::pair<double, double> heights_above_floor_m(const calc::CalcPlane& plane,
                                                const calc::Space& space);

// Whether every place lies on a surface of a body whose id ends so (".ceiling", ".wall2": before
// the digits), within 5 cm, and faces away from it. True for spaces that do not know their walls.
bool lies_on(const calc::CalcPlane& plane, const calc::Space& space, std::string_view part);

// Whether every luminaire lies behind every place: only reflected light reaches it. False without
// luminaires.
bool faces_away(const calc::CalcPlane& plane, const calc::Space& space);

}  // namespace rules
