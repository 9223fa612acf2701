#pragma once
// A tree of boxes over the triangles of a scene, flattened for a traversal that needs no stack.

#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace gpu {

// Nodes stand in depth-first order: the first child of a node follows it, and `next` leads past all
// that is below it, for rays that miss its box. As the shader reads it: two uvec4.
struct BvhNode {
  std::array<float, 3> low_m;
  std::uint32_t next;
  std::array<float, 3> high_m;
  std::uint32_t leaf;  // 0 = inner node, else first triangle * kLeafStep + number of triangles
};
static_assert(sizeof(BvhNode) == 32);

inline constexpr std::uint32_t kLeafStep = 8;  // more than a leaf holds

// Corners, and in the last component of each a coordinate of the unit normal.
struct BvhTriangle {
  std::array<glm::vec4, 3> corner_m;
};
static_assert(sizeof(BvhTriangle) == 48);

struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<BvhTriangle> triangles;  // in the order of leaves
  std::vector<std::uint32_t> order;    // which of the scene's triangles they are
};

// Splits where the summed area of boxes, times their triangles, is least among 16 bins of each
// axis [Wald07]. A function of the scene alone, on all threads. Fewer than 2^29 triangles.
Bvh build_bvh(const calc::PreparedScene& scene);

}  // namespace gpu
