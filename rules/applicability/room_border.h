#pragma once
// How far a plane is from the walls beside it.

#include "calc/scene/project.h"

namespace rules {

// Of the outline of a level area, in plan, metres; parts of it that lie outside the room are at the
// wall. Of a room whose floor plan is known: of the part that is farthest off. Of a room from a
// building file, whose walls nobody names: from whatever is upright there, a tenth above the area,
// and without the fifth of the outline that is farthest off, for doors. Infinite where there is
// nothing upright, and in the open.
double distance_from_walls_m(const calc::PlanarArea& area, const calc::Space& space);

}  // namespace rules
