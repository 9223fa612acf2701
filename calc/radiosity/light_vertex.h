#pragma once
// Points where light paths were reflected: the virtual point lights of instant radiosity.
// [Keller97]

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// One replicate's vertices as arrays, grouped by light channel, in path order within a channel.
struct LightVertices {
  std::vector<glm::vec3> position_m;  // local, lifted off the surface on the side that reflects
  std::vector<glm::vec3> normal;      // unit, on the side that reflects
  std::vector<double> flux_lm;        // reflected flux that the vertex stands for, > 0
  std::vector<float> bound_per_m2;    // upper bound of the geometry term, see near_field.h
  std::vector<std::uint32_t> channel_begin;  // channels + 1 entries

  std::size_t size() const { return position_m.size(); }
  std::size_t channels() const { return channel_begin.empty() ? 0 : channel_begin.size() - 1; }
};

}  // namespace calc
