#pragma once
// A binary tree of boxes over the triangles of a scene, from which the device's tree is made.

#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace gpu {

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};

  bool is_empty() const { return low.x > high.x; }
  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  // Returns half of the area; 0 if nothing is inside.
  float area() const {
    const glm::vec3 d = glm::max(high - low, glm::vec3(0.0f));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
  glm::vec3 middle() const { return 0.5f * low + 0.5f * high; }
};

struct BoxTree {
  // The longest path from the root to a leaf.
  static constexpr int kMostHeight = 48;

  struct Node {
    Box box;
    std::size_t first = 0, count = 0;  // of `order`
    std::size_t second_child = 0;      // 0 = leaf; the first child follows the node
    int height = 0;                    // of the longest path to a leaf
    bool is_leaf() const { return second_child == 0; }
  };

  std::vector<Node> nodes;           // the root first; not all are in use. Empty without triangles
  std::vector<std::uint32_t> order;  // the scene's triangles, those of a node one after another
};

// Builds the tree; splits where the summed area of boxes, times their triangles, is least among 16
// bins of each axis [Wald07]. Depends only on the scene; runs on all threads.
BoxTree build_box_tree(const calc::PreparedScene& scene, std::size_t most_per_leaf);

}  // namespace gpu
