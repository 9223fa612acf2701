#pragma once
// The searches of TriangleTree, compiled for every width of vectors; chosen when the program runs.

#include "calc/rays/triangle_tree.h"

namespace calc {

// The data of a tree for the searches; it must have triangles.
struct TreeView {
  explicit TreeView(const TriangleTree& tree)
      : triangles(tree.triangles_.data()),
        nodes(tree.nodes_.data()),
        blocks(tree.blocks_.data()),
        root(tree.root_),
        largest_m(tree.largest_m_),
        reach_m(tree.reach_m_) {}

  const Triangle* triangles;
  const TriangleTree::Node* nodes;
  const TriangleTree::Block* blocks;
  TriangleTree::Child root;
  float largest_m, reach_m;
};

// Search like TriangleTree::blocked() and first_hits().
std::uint32_t blocked_rays(const TreeView& tree, std::span<const Ray> rays);
std::uint32_t first_hits_of_rays(const TreeView& tree, std::span<const Ray> rays,
                                 std::span<TriangleHit> hits);

}  // namespace calc
