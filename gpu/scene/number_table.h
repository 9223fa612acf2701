#pragma once
// Builds arrays of numbers for shaders.

#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gpu {

inline void add(std::vector<double>& table, const glm::dvec3& v) {
  table.insert(table.end(), {v.x, v.y, v.z});
}

inline void add(std::vector<double>& table, const std::vector<double>& values) {
  table.insert(table.end(), values.begin(), values.end());
}

// Returns the 32 direction numbers of each of the first dimensions, in the layout of samples.glsl.
inline std::vector<std::uint32_t> sobol_words(int dimensions) {
  std::vector<std::uint32_t> words;
  for (int dimension = 0; dimension < dimensions; ++dimension) {
    for (int bit = 0; bit < 32; ++bit) {
      words.push_back(calc::ScrambledSobol::direction_number(dimension, bit));
    }
  }
  return words;
}

// Adds a luminaire's place and opening: position, three axes, half sizes, calc::OpeningShape; 16
// numbers.
inline void add_placement(std::vector<double>& table, const calc::PlacedLuminaire& luminaire) {
  add(table, luminaire.position_m);
  for (int axis = 0; axis < 3; ++axis) add(table, luminaire.world_from_luminaire[axis]);
  add(table, 0.5 * luminaire.opening.size_m());
  table.push_back(static_cast<double>(luminaire.opening.shape));
}

}  // namespace gpu
