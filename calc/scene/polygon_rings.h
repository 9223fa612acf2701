#pragma once
// Divides outlines that touch themselves: a hole that a doubled side joins to its outline, two
// parts that share a corner. Sides that go there and back cancel out; rings remain.

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace calc {

struct RingSet {
  // Simple, indices into the outline's corners; parts turn as the outline does, holes the other
  // way.
  std::vector<std::vector<std::uint32_t>> ring;
  double longest = 0.0;          // of the sides that cancelled out
  std::uint32_t longest_at = 0;  // a corner of it
};

// Splits an outline without doubled corners and spikes. Empty if sides cross, or if an area is
// enclosed twice or none is.
std::optional<RingSet> split_into_rings(const std::vector<glm::dvec2>& outline);

// Returns triangles by ear clipping, holes joined to their parts by a way there and back between
// two corners. They wind as the parts do and fill the rings' area to 1e-9; otherwise empty.
std::optional<std::vector<glm::uvec3>> triangulate_rings(
    const std::vector<glm::dvec2>& corner, const std::vector<std::vector<std::uint32_t>>& ring);

}  // namespace calc
