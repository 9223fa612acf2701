#pragma once
// Points where light paths were reflected: the virtual point lights of instant radiosity.
// [Keller97]

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// 32 bytes, half a cache line, because a connection reads a vertex at a random place.
struct LightVertex {
  glm::vec3 position_m;  // local, lifted off the surface on the side that reflects
  float flux_lm;         // reflected flux of the vertex, > 0
  glm::vec3 normal;      // unit, on the side that reflects
  std::uint32_t channel;
};
static_assert(sizeof(LightVertex) == 32);

using LightVertices = std::vector<LightVertex>;

}  // namespace calc
