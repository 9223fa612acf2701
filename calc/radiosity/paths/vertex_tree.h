#pragma once
// The pool of light vertices of one replicate, sorted in space, and a binary tree of groups over
// it.

#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/sampling/identity.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

// A node: vertices first..last of the sorted pool. Children, if any, are `child` and `child` + 1;
// leaves are single vertices. [leaves of up to four made half widths in offices 1.3 to 1.45 times
// as wide, in 0 to 20 % less time: measured; a cut of all leaves, exact weights, makes them 2 to 4
// % narrower]
struct VertexNode {
  std::uint32_t first = 0, last = 0;
  std::uint32_t child = 0;  // 0 = leaf
  std::uint32_t channel = 0;
  float flux_lm = 0.0f;     // sum
  float radius_m = 0.0f;    // half the diagonal of the box
  float cos_spread = 1.0f;  // smallest cosine between axis and a normal
  float per_m2 = 0.0f;      // vertices per area around, of at least kDensityCount vertices
  glm::vec3 centre_m{0.0f}, half_m{0.0f};  // box that holds all positions
  glm::vec3 axis{0.0f};  // unit mean normal; 0 if normals cancel, then cos_spread is -1

  std::uint32_t size() const { return last - first; }
  // Returns the vertex whose place and normal represent the node. [one serves as well as the mean
  // over four, at the same size of the cut: measured]
  std::uint32_t representative() const { return first + size() / 2; }
};

class VertexTree {
 public:
  // Sorts by channel, then by the side that normals face, then along a space-filling curve
  // (Morton), and cuts where the sort key's highest bit changes, so that a node holds neighbours on
  // one surface. Order of equal keys is kept: the result depends on the vertices only.
  VertexTree(LightVertices vertices, std::size_t channels);

  // Returns the identity of these vertices, see new_identity().
  std::uint64_t identity() const { return identity_; }
  const LightVertices& vertices() const { return vertices_; }
  // Returns the flux of the vertices before index i, lm.
  double flux_before_lm(std::size_t i) const { return flux_before_lm_[i]; }
  // Returns [vertex], and one more: all flux.
  std::span<const double> flux_before_lm() const { return flux_before_lm_; }
  // Returns the vertex in first..last at which the summed flux reaches flux_before_lm(first) +
  // share of the range's flux; share in [0, 1).
  std::uint32_t vertex_at(std::uint32_t first, std::uint32_t last, double share) const;
  std::span<const VertexNode> nodes() const { return nodes_; }
  // Returns the roots, one per channel that has vertices, in order of channels.
  std::span<const std::uint32_t> roots() const { return roots_; }

 private:
  std::uint64_t identity_ = new_identity();
  LightVertices vertices_;
  std::vector<double> flux_before_lm_;  // vertices + 1 entries
  std::vector<VertexNode> nodes_;
  std::vector<std::uint32_t> roots_;
};

}  // namespace calc
