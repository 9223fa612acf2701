#pragma once
// Distance of a plane from the walls beside it.

#include "calc/scene/project.h"

namespace rules {

// Returns the distance in metres of the outline of a level area, in plan; parts outside the room
// are at the wall. If the room's floor plan is known, the farthest part counts. In a room from a
// building file, whose walls have no names, it is the distance from upright surfaces a tenth above
// the area, without the farthest fifth of the outline, because of doors. Infinite if nothing is
// upright, and in the open.
double distance_from_walls_m(const calc::PlanarArea& area, const calc::Space& space);

}  // namespace rules
