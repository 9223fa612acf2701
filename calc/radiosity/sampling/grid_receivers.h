#pragma once
// The points of a grid as receivers.

#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace calc {

// Unit directions across the unit axis, 90 degrees apart; quarter: 0 to 3. Of a vertical axis +x,
// +y, -x, -y.
glm::dvec3 side_of_axis(const glm::dvec3& axis, std::size_t quarter);

// One per point, in order, in local coordinates; of a derived quantity several, all of the first
// kind before those of the next: of modelling the cylinder, then the plane across its axis; of
// four_planes the cylinder, then the planes along its axis. They stand where the grid's points are
// measured from (SensorGrid::shift_m).
std::vector<Receiver> receivers_of(const Tracer& tracer, const SensorGrid& grid);

}  // namespace calc
