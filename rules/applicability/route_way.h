#pragma once
// Whether people can go a route from end to end.

#include "calc/base/message.h"
#include "calc/scene/sensor_grid.h"

#include <string>

namespace rules {

// Between two neighbouring stations of a route, a metre above what people walk on, something stands
// in the way of every row; or a station has no point at all. In words, with the first place:
// "nobody gets past (5, 1, 0) m: 'wall' stands across the whole width"; "" = nothing does, or it is
// no route.
calc::Message barred_words(const calc::SensorGrid& grid, const calc::Space& space);

}  // namespace rules
