#pragma once
// The quantity of a point as planar illuminances that Radiance calculates: one, or several in
// directions about its axis with a weighted sum.

#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace cli::radiance {

// Distance by which points are lifted off surfaces, along their normals.
inline constexpr double kLift_m = 1e-4;

struct Sensor {
  glm::dvec3 position_m, direction;  // world; unit
  double weight;                     // of its illuminance in the sum
};

// Returns whether a quantity is such a sum. Ratings and ratios are not.
bool is_sum_of_sensors(calc::DerivedQuantity derived);

// Returns the sensors of point i; the quantity of the grid must be such a sum. If several
// directions replace an integral, the error of the sum is at most directions_error() of the light's
// share in it, in the worst case of light from a single direction.
std::vector<Sensor> sensors_of(const calc::SensorGrid& grid, std::size_t i);

// Returns "" if the sum is exact, else how the quantity is summed and its largest error, in words.
std::string sum_words(const calc::SensorGrid& grid);

}  // namespace cli::radiance
