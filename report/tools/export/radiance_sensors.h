#pragma once
// What a point measures, as planar illuminances that Radiance gives: one, or several in directions
// about its axis whose weighted sum is the quantity.

#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace cli::radiance {

// Points are lifted off surfaces they may lie in by this distance, along their normals.
inline constexpr double kLift_m = 1e-4;

struct Sensor {
  glm::dvec3 position_m, direction;  // world; unit
  double weight;                     // of its illuminance in the sum
};

// Whether a quantity is such a sum. Ratings and ratios are not.
bool is_sum_of_sensors(calc::DerivedQuantity derived);

// Of point i; the grid must be such a sum. Where several directions stand for an integral, the sum
// is off by at most directions_error() of the light's share in it, in the worst case of light from
// one direction alone.
std::vector<Sensor> sensors_of(const calc::SensorGrid& grid, std::size_t i);

// "": exact. Else how the quantity is summed and how far that may be off, in words.
std::string sum_words(const calc::SensorGrid& grid);

}  // namespace cli::radiance
