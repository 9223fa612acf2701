#pragma once
// Obstacles that end a zone around a task as a wall does: racks, cupboards, columns.

#include "calc/scene/sensor_grid.h"

#include <cstddef>

namespace rules {

// Least height of an obstacle above a point inside it. A lower body may be a table top drawn too
// high; inside a higher one nobody works, and there is no plane to light.
inline constexpr double kObstacleAbove_m = 0.5;

// Returns how many of the grid's dropped points lie inside obstacles.
std::size_t points_in_obstacles(const calc::SensorGrid& grid, const calc::Space& space);

// Returns how many of them lie inside bodies that fill very little of a cell, such as posts: the
// light beside them is that of the cell, and a minimum or uniformity without it says nothing. 0 for
// point lists.
std::size_t points_in_posts(const calc::SensorGrid& grid, const calc::Space& space);

}  // namespace rules
