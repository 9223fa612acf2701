#pragma once
// A tree of boxes over the triangles of a scene for shaders: eight children to a node, their boxes
// in steps of a grid of the node's own, a byte for each plane. [Ylitie17]

#include "calc/scene/prepared_scene.h"
#include "gpu/scene/box_tree.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpu {

inline constexpr std::size_t kBvhWidth = 8;
inline constexpr std::size_t kMostPerLeaf = 3;  // 1 to 4
// Nodes on a path from the root; a search keeps one word pair for each but the root. Three levels
// of the binary tree make at least one level of this.
inline constexpr int kBvhLevels = BoxTree::kMostHeight / 3;

// A node in the shader's layout, five uvec4. Children are in slots: bit k of a slot's number is 1
// if the child is farther along axis k than others, so that a ray meets slots about in the order of
// `slot ^ signs of its direction`. A plane is at low_m + step * number, in real numbers.
struct BvhNode {
  std::array<float, 3> low_m;
  std::array<std::uint8_t, 3> step;  // exponent bits of a float
  std::uint8_t inner;                // slots whose child is a node
  std::uint32_t first_child;         // nodes, one after another by slot
  std::uint32_t first_triangle;      // those of leaves, one after another by slot
  std::uint32_t triangles;           // 4 bits per slot, as many set as the leaf has triangles
  std::uint32_t unused;
  std::array<std::array<std::uint8_t, kBvhWidth>, 3> low, high;  // [axis][slot]
};
static_assert(sizeof(BvhNode) == 80 && 4 * kBvhWidth <= 32 && kMostPerLeaf <= 4);

// Corners, with a coordinate of the unit normal in the last component of each.
struct BvhTriangle {
  std::array<glm::vec4, 3> corner_m;
};
static_assert(sizeof(BvhTriangle) == 48);

struct Bvh {
  std::vector<BvhNode> nodes;          // the root first
  std::vector<BvhTriangle> triangles;  // in the order of leaves
  std::vector<std::uint32_t> order;    // which of the scene's triangles they are
};

// Builds the tree of fewer than 2^29 triangles; it depends only on the scene.
Bvh build_bvh(const calc::PreparedScene& scene);

// Returns the least step of grids in a scene with coordinates up to this, so that rays along an
// axis, whose direction the shader changes from 0 to a tiny number, stay within its margins.
float least_step_m(float largest_coordinate_m);
// Sets the grid and planes that hold the children's boxes; empty ones are slots without a child.
void set_boxes(BvhNode& node, const std::array<Box, kBvhWidth>& child, float least_step_m);

}  // namespace gpu
