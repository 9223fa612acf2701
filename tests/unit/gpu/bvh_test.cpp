#include "gpu/bvh.h"

#include "calc/radiosity/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace test_support;

// Every triangle once, inside the boxes of its leaf and of all nodes above it; `next` leads past
// what is below. Returns the depth.
void expect_sound(const calc::PreparedScene& scene, const gpu::Bvh& bvh) {
  ASSERT_EQ(bvh.triangles.size(), scene.triangle.size());
  std::vector<int> seen(bvh.triangles.size(), 0);
  for (std::size_t n = 0; n < bvh.nodes.size(); ++n) {
    const gpu::BvhNode& node = bvh.nodes[n];
    ASSERT_GT(node.next, n);
    ASSERT_LE(node.next, bvh.nodes.size());
    if (node.leaf != 0) {
      EXPECT_EQ(node.next, n + 1);
      EXPECT_LE(node.leaf % gpu::kLeafStep, 4u);
    }
    for (std::size_t below = n; below < node.next; ++below) {
      const std::uint32_t leaf = bvh.nodes[below].leaf;
      ASSERT_LE(bvh.nodes[below].next, node.next);
      for (std::uint32_t k = 0; k < leaf % gpu::kLeafStep; ++k) {
        const std::size_t triangle = leaf / gpu::kLeafStep + k;
        if (below == n) ++seen.at(triangle);
        for (const glm::vec4& corner : bvh.triangles.at(triangle).corner_m) {
          for (int axis = 0; axis < 3; ++axis) {
            ASSERT_GE(corner[axis], node.low_m[static_cast<std::size_t>(axis)]);
            ASSERT_LE(corner[axis], node.high_m[static_cast<std::size_t>(axis)]);
          }
        }
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

TEST(Bvh, HoldsEveryTriangleOnceInsideItsBoxes) {
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, 0}, {4, 4, 3}, 0.5);
  add_sphere(scene, 1.0, 3, 0.5);
  const gpu::Bvh bvh = gpu::build_bvh(scene);
  expect_sound(scene, bvh);
  EXPECT_GT(bvh.nodes.size(), scene.triangle.size() / 4);  // no heap of triangles in one leaf
}

TEST(Bvh, IsEmptyWithoutTriangles) {
  EXPECT_TRUE(gpu::build_bvh(calc::PreparedScene()).nodes.empty());
}

// 5000 triangles in one place and others in distances that double: nothing to split by, and a tree
// that would grow into a list.
TEST(Bvh, EndsWhereTrianglesCannotBeToldApart) {
  calc::PreparedScene scene;
  for (int k = 0; k < 5000; ++k) add_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.5);
  double x = 1.0;
  for (int k = 0; k < 100; ++k, x *= 2.0) {
    add_triangle(scene, {x, 0, 0}, {1.1 * x, 0, 0}, {x, 0.1 * x, 0}, 0.5);
  }
  expect_sound(scene, gpu::build_bvh(scene));
}

TEST(Bvh, NormalsStandInTheLastComponents) {
  calc::PreparedScene scene;
  add_triangle(scene, {0, 0, 2}, {3, 0, 2}, {0, 5, 2}, 0.5);
  const gpu::Bvh bvh = gpu::build_bvh(scene);
  EXPECT_EQ(bvh.triangles[0].corner_m[0], glm::vec4(0, 0, 2, 0));
  EXPECT_EQ(bvh.triangles[0].corner_m[1], glm::vec4(3, 0, 2, 0));
  EXPECT_EQ(bvh.triangles[0].corner_m[2], glm::vec4(0, 5, 2, 1));
}

}  // namespace
