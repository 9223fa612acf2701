#pragma once
// Makes receivers of the points of a grid.

#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace calc {

// Returns a unit direction across the unit axis, 90 degrees apart; quarter: 0 to 3. For a vertical
// axis +x, +y, -x, -y.
glm::dvec3 side_of_axis(const glm::dvec3& axis, std::size_t quarter);

// Returns one receiver per point, in order, in local coordinates; for a derived quantity several,
// all of the first kind before those of the next: for modelling the cylinder, then the plane across
// its axis; for four_planes the cylinder, then the planes along its axis. They are where the grid's
// points are measured (SensorGrid::shift_m).
std::vector<Receiver> receivers_of(const Tracer& tracer, const SensorGrid& grid);

}  // namespace calc
