#pragma once
// Tests whether a surface has a rim: a closed surface has none.

#include "calc/meshes/mesh_check.h"

namespace cli {

// Returns true if every piece of every edge has an even number of triangles beside it, also if
// edges overlap only partly (a window in a wall, a wall beside two rooms): then inside and outside
// do not depend on the direction of a ray. Gaps up to 1e-5 of the model's size are ignored. Returns
// false also if that cannot be found: corners that are not finite, or more than 4000 edges without
// an equal edge.
bool is_rimless(const calc::SurfaceModel& model);

}  // namespace cli
