#pragma once
// What ends a zone around a task as a wall does: racks, cupboards, columns.

#include "calc/scene/sensor_grid.h"

#include <cstddef>

namespace rules {

// A body that reaches so far above a point inside it is no table top that somebody has drawn too
// high: nobody works there, and there is no plane to light.
inline constexpr double kObstacleAbove_m = 0.5;

// How many of the grid's dropped points lie inside obstacles.
std::size_t points_in_obstacles(const calc::SensorGrid& grid, const calc::Space& space);

// How many of them lie inside bodies that take next to nothing of a cell, such as posts: the light
// beside them is that of the cell, and a minimum or a uniformity without it says nothing. 0 of
// point lists.
std::size_t points_in_posts(const calc::SensorGrid& grid, const calc::Space& space);

}  // namespace rules
