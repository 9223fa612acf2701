#pragma once
// Points of a plane's area that are not used, because something stands there.

#include "calc/base/message.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <string>

namespace rules {

struct LostPoints {
  std::size_t lost = 0, all = 0;
  calc::Message
      words;  // "50 of 60 points are left out: 48 inside 'desk', 2 outside the room"; or ""

  double share() const;  // [0, 1]
};

// Counts the points within the outline and its margin that lie inside bodies, in their surfaces or
// beyond the walls; on a route also those with an obstacle in the way or without a floor below.
LostPoints lost_points(const calc::SensorGrid& grid);

// Returns "3 of 20 points lie in a surface that stands on the plane, the first in 'cupboard', and
// are measured just off it"; "" if there are none (SensorGrid::inner).
calc::Message inner_words(const calc::SensorGrid& grid);

}  // namespace rules
