#pragma once
// A tree of boxes over triangles, for queries whose answers do not depend on the processor.
//
// Boxes and a first test of triangles are computed in single precision, in vectors as wide as the
// processor has. They only ever exclude what provably cannot be met, with bounds on every rounding,
// and meets() decides the rest, in double. So answers depend neither on the order of a search nor
// on the width of vectors nor on fused multiplications.

#include "calc/rays/triangle_hit.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace calc {

class TriangleTree {
 public:
  static constexpr std::size_t kRays = 16;  // of one call, at most

  TriangleTree() = default;
  // Builds a tree with Embree, on all threads. Requires corners in metres, fewer than 2^31
  // triangles of non-zero area. Throws std::runtime_error if Embree fails.
  TriangleTree(std::span<const glm::vec3> vertex_m, std::span<const glm::uvec3> corners);

  bool is_empty() const { return triangles_.empty(); }
  std::size_t size() const { return triangles_.size(); }
  const Triangle& triangle(std::size_t index) const { return triangles_[index]; }

  // Returns a mask: bit k is set if ray k meets any triangle.
  std::uint32_t blocked(std::span<const Ray> rays) const;

  // Returns a mask: bit k is set, and hits[k] valid, if ray k meets a triangle; the first by
  // TriangleHit::is_before(). hits: one per ray.
  std::uint32_t first_hits(std::span<const Ray> rays, std::span<TriangleHit> hits) const;

  // Calls visit(triangle index) for every triangle that may be within radius_m of a point, in no
  // defined order. It returns the next radius, at most the one before.
  template <class Visit>
  void visit_near(const glm::dvec3& point_m, double radius_m, const Visit& visit) const;

  // Calls visit(triangle index) for every triangle in boxes for which keep(node, lane) is true, in
  // no defined order, until it returns false.
  template <class Keep, class Visit>
  void visit_if(const Keep& keep, const Visit& visit) const;

  // A child of a node: another node, or a block of triangles, or none.
  using Child = std::uint32_t;
  static constexpr Child kBlock = 0x8000'0000;  // flag; the rest is an index
  static constexpr Child kNone = 0xffff'ffff;
  static constexpr std::size_t kWidth = 8;
  using Lanes = std::array<float, kWidth>;

  // Boxes of up to eight children. For missing children low is +infinity, high -infinity.
  struct alignas(64) Node {
    std::array<Lanes, 3> low_m, high_m;
    std::array<Child, kWidth> child;
  };

  // Up to eight triangles, in single precision.
  struct alignas(64) Block {
    std::array<Lanes, 3> normal;                 // unit
    Lanes height_m;                              // of the plane over the origin, along the normal
    std::array<std::array<Lanes, 3>, 3> edge;    // [which][axis]: b to c, c to a, a to b
    std::array<std::array<Lanes, 3>, 3> moment;  // [which][axis]: edge x (begin + end)
    Lanes edge_error;  // times edge_scale() of a ray: what rounding may do to its side of an edge
    std::array<std::uint32_t, kWidth> index;
    std::uint32_t count;
  };

 private:
  friend struct TreeView;
  class Builder;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
  Child root_ = kNone;
  float largest_m_ = 0.0f;  // coordinate, rounded up
  float reach_m_ = 0.0f;    // of the corner farthest from the origin, rounded up
};

// Returns "Embree 3.13.5", the library that builds the trees. No answer depends on it: `luxgate
// version` names it, results do not.
std::string tree_builder_version();

namespace tree_detail {

// Returns the squared distance of a point from a box, m2.
inline double squared_distance(const TriangleTree::Node& node, std::size_t lane,
                               const glm::dvec3& point_m) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = point_m[static_cast<glm::length_t>(axis)];
    const double below = static_cast<double>(node.low_m[axis][lane]) - at;
    const double above = at - static_cast<double>(node.high_m[axis][lane]);
    const double apart = below > above ? below : above;
    if (apart > 0.0) sum += apart * apart;
  }
  return sum;
}

inline constexpr std::size_t kStack = 512;  // the builder refuses deeper trees

}  // namespace tree_detail

template <class Keep, class Visit>
void TriangleTree::visit_if(const Keep& keep, const Visit& visit) const {
  if (root_ == kNone) return;
  std::array<Child, tree_detail::kStack> stack;
  std::size_t size = 0;
  stack[size++] = root_;
  while (size > 0) {
    const Child child = stack[--size];
    if ((child & kBlock) != 0) {
      const Block& block = blocks_[child & ~kBlock];
      for (std::uint32_t lane = 0; lane < block.count; ++lane) {
        if (!visit(block.index[lane])) return;
      }
      continue;
    }
    const Node& node = nodes_[child];
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      if (node.child[lane] != kNone && keep(node, lane)) stack[size++] = node.child[lane];
    }
  }
}

template <class Visit>
void TriangleTree::visit_near(const glm::dvec3& point_m, double radius_m,
                              const Visit& visit) const {
  constexpr double kRounding = 1.0 + 1e-9;  // far above that of the squares
  visit_if(
      [&](const Node& node, std::size_t lane) {
        return tree_detail::squared_distance(node, lane, point_m) <=
               radius_m * radius_m * kRounding;
      },
      [&](std::uint32_t index) {
        radius_m = visit(index);
        return true;
      });
}

}  // namespace calc
