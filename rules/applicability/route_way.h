#pragma once
// Checks whether people can walk a route from end to end.

#include "calc/base/message.h"
#include "calc/scene/sensor_grid.h"

#include <string>

namespace rules {

// Returns where a route is blocked: between two neighbouring stations, a metre above the floor, an
// obstacle crosses every row, or a station has no point at all. In words, with the first place:
// "nobody gets past (5, 1, 0) m: 'wall' stands across the whole width"; "" if it is free or no
// route.
calc::Message barred_words(const calc::SensorGrid& grid, const calc::Space& space);

}  // namespace rules
