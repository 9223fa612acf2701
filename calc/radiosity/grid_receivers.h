#pragma once
// The points of a grid as receivers.

#include "calc/radiosity/rays.h"
#include "calc/radiosity/receiver.h"
#include "calc/scene/sensor_grid.h"

#include <vector>

namespace calc {

// One per point, in order, in local coordinates; of a derived quantity several, all of the first
// kind before those of the next: of modelling the cylinder, then the plane across its axis; of
// four_planes the cylinder, then the planes along its axis. A planar receiver keeps its place and
// looks away from the surface that it may lie in. Any other one sees that surface, too: it is moved
// off it, to the side that SensorGrid::front() gives, so that it is clear what it sees.
std::vector<Receiver> receivers_of(const Tracer& tracer, const SensorGrid& grid);

}  // namespace calc
