#pragma once
// Outlines that touch themselves, taken apart: a hole that a doubled side joins to its outline, two
// parts that share a corner. Sides that go there and back cancel out; what is left are rings.

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

// Of an outline without doubled corners and spikes. Empty if sides cross, something is enclosed
// twice or nothing is.
std::optional<RingSet> split_into_rings(const std::vector<glm::dvec2>& outline);

// Ear clipping, holes joined to their parts by a way there and back between two corners. Triangles
// turn as the parts do and fill what the rings enclose, to 1e-9 of its area. Empty if not.
std::optional<std::vector<glm::uvec3>> triangulate_rings(
    const std::vector<glm::dvec2>& corner, const std::vector<std::vector<std::uint32_t>>& ring);

}  // namespace calc
