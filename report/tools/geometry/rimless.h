#pragma once
// Whether a surface has a rim anywhere: a closed one has none.

#include "calc/meshes/mesh_check.h"

namespace cli {

// True if every piece of every edge has an even number of triangles beside it, also where edges
// only partly lie on each other (a window in a wall, a wall beside two rooms): then a point is
// inside or outside whatever the direction looked in. Gaps up to 1e-5 of the model's size are
// passed over. False also where that is not found out: corners that are not finite, or more than
// 4000 edges that have no equal.
bool is_rimless(const calc::SurfaceModel& model);

}  // namespace cli
