#pragma once
// Points of a plane's area that take part in nothing, because something stands there.

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

// Of those within the outline and its margin: what lies inside bodies, in their surfaces or beyond
// the walls; of a route also where something stands in the way, or where nothing is walked on.
LostPoints lost_points(const calc::SensorGrid& grid);

// "3 of 20 points lie in a surface that stands on the plane, the first in 'cupboard', and are
// measured just off it"; "": none (SensorGrid::inner).
calc::Message inner_words(const calc::SensorGrid& grid);

}  // namespace rules
