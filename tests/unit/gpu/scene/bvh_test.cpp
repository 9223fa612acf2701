#include "gpu/scene/bvh.h"

#include "calc/radiosity/sampling/random.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace bvh_test {
namespace {

using namespace test_support;

double step_m(const gpu::BvhNode& node, std::size_t axis) {
  return std::ldexp(1.0, node.step[axis] - 127);
}

// The sign of place - (begin + steps * step), in real numbers.
int compare(float place, float begin, double steps, double step) {
  const double a = place, b = begin, way = a - b;  // and what rounding took from it
  const double of_b = a - way, rest = (a - (way + of_b)) - (b - of_b);
  const double off = way - steps * step;  // 0 only if it is exactly that
  return off != 0.0 ? (off > 0.0 ? 1 : -1) : (rest > 0.0) - (rest < 0.0);
}

bool holds(const gpu::BvhNode& node, std::size_t slot, const glm::vec3& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float place = p[static_cast<int>(axis)];
    const double step = step_m(node, axis);
    if (compare(place, node.low_m[axis], node.low[axis][slot], step) < 0) return false;
    if (compare(place, node.low_m[axis], node.high[axis][slot], step) > 0) return false;
  }
  return true;
}

class Soundness {
 public:
  explicit Soundness(const gpu::Bvh& bvh) : bvh_(bvh), triangle_(bvh.triangles.size()) {}

  // Triangles of a subtree, after all of it was looked at.
  std::vector<std::uint32_t> below(std::uint32_t at, int level) {
    ++nodes;
    levels = std::max(levels, level);
    const gpu::BvhNode& node = bvh_.nodes.at(at);
    std::vector<std::uint32_t> all;
    std::uint32_t child = node.first_child, first = node.first_triangle;
    for (std::size_t slot = 0; slot < gpu::kBvhWidth; ++slot) {
      std::vector<std::uint32_t> own;
      const std::uint32_t bits = (node.triangles >> (4 * slot)) & 0xfu;
      if (((node.inner >> slot) & 1u) != 0) {
        EXPECT_EQ(bits, 0u);
        EXPECT_GT(child, at);
        own = below(child++, level + 1);
      } else {
        EXPECT_TRUE(std::has_single_bit(bits + 1));  // the lowest ones
        for (int k = 0; k < std::popcount(bits); ++k) {
          own.push_back(first);
          ++triangle_.at(first++);
        }
      }
      for (const std::uint32_t t : own) {
        for (const glm::vec4& corner : bvh_.triangles[t].corner_m) {
          if (!holds(node, slot, glm::vec3(corner))) ++outside;
        }
      }
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }

  bool has_each_once() const {
    return std::all_of(triangle_.begin(), triangle_.end(), [](int count) { return count == 1; });
  }

  std::size_t nodes = 0, outside = 0;
  int levels = 0;

 private:
  const gpu::Bvh& bvh_;
  std::vector<int> triangle_;
};

// Every triangle once, inside the boxes of all nodes above it; no deeper than the shader's stack.
void expect_sound(const calc::PreparedScene& scene) {
  const gpu::Bvh bvh = gpu::build_bvh(scene);
  ASSERT_EQ(bvh.triangles.size(), scene.triangle.size());
  Soundness sound(bvh);
  sound.below(0, 1);
  EXPECT_EQ(sound.nodes, bvh.nodes.size());
  EXPECT_EQ(sound.outside, 0u);
  EXPECT_TRUE(sound.has_each_once());
  EXPECT_LE(sound.levels, gpu::kBvhLevels);
  EXPECT_LE(2 * (bvh.nodes.size() - 1), bvh.triangles.size());
  for (std::size_t k = 0; k < bvh.order.size(); ++k) {
    const glm::vec3 corner(bvh.triangles[k].corner_m[0]);
    ASSERT_EQ(corner, scene.vertex_m[scene.triangle[bvh.order[k]].x]);
  }
}

TEST(Bvh, HoldsEveryTriangleOnceInsideItsBoxes) {
  calc::PreparedScene scene;
  add_box(scene, {-2, -2, 0}, {4, 4, 3}, 0.5);
  add_sphere(scene, 1.0, 3, 0.5);
  expect_sound(scene);
  const gpu::Bvh bvh = gpu::build_bvh(scene);
  EXPECT_GT(bvh.nodes.size(), scene.triangle.size() / 24);  // leaves hold up to 3, nodes 8 leaves
  EXPECT_LT(bvh.nodes.size(), scene.triangle.size() / 4);
}

TEST(Bvh, IsEmptyWithoutTriangles) {
  EXPECT_TRUE(gpu::build_bvh(calc::PreparedScene()).nodes.empty());
}

TEST(Bvh, HoldsASingleTriangle) {
  calc::PreparedScene scene;
  add_triangle(scene, {0, 0, 2}, {3, 0, 2}, {0, 5, 2}, 0.5);
  expect_sound(scene);
}

// 5000 triangles in one place and others in distances that double: nothing to split by, and trees
// that would grow into a list.
TEST(Bvh, EndsWhereTrianglesCannotBeToldApart) {
  calc::PreparedScene scene;
  for (int k = 0; k < 5000; ++k) add_triangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.5);
  double x = 1.0;
  for (int k = 0; k < 100; ++k, x *= 2.0) {
    add_triangle(scene, {x, 0, 0}, {1.1 * x, 0, 0}, {x, 0.1 * x, 0}, 0.5);
  }
  expect_sound(scene);
}

// Triangles shrink towards a corner, so that the small one of two parts is a leaf at each split and
// the largest box of a node is never the one that is deep: every level of the tree is used up.
TEST(Bvh, IsNeverDeeperThanTheStack) {
  for (const double factor : {0.9, 0.7, 0.5, 0.3}) {
    calc::PreparedScene scene;
    double x = 1e5;
    for (int k = 0; k < 2000 && x > 1e-30; ++k, x *= factor) {
      add_triangle(scene, {x, 0, 0}, {x, factor * x, 0}, {x, 0, factor * x}, 0.5);
      for (int j = 0; j < 8; ++j) {
        add_triangle(scene, {x, x, 0.01 * x * j}, {2 * x, x, 0}, {x, 2 * x, 0.3 * x}, 0.5);
      }
    }
    expect_sound(scene);
  }
}

// Sheets that draw nearer to a pile faster than bins become narrow, so that a split takes off one:
// the halves of what cannot be told apart must still find room.
TEST(BoxTree, IsNoHigherThanItSays) {
  calc::PreparedScene scene;
  for (double x = 1e18; x > 1e-32; x *= 0.06) {
    add_triangle(scene, {x, 0, 0}, {x, 1, 0}, {x, 0, 1}, 0.5);
  }
  for (int k = 0; k < 3000; ++k) add_triangle(scene, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5);
  const gpu::BoxTree tree = gpu::build_box_tree(scene, 1);
  EXPECT_EQ(tree.nodes.front().height, gpu::BoxTree::kMostHeight);
}

TEST(Bvh, NormalsStandInTheLastComponents) {
  calc::PreparedScene scene;
  add_triangle(scene, {0, 0, 2}, {3, 0, 2}, {0, 5, 2}, 0.5);
  const gpu::Bvh bvh = gpu::build_bvh(scene);
  EXPECT_EQ(bvh.triangles[0].corner_m[0], glm::vec4(0, 0, 2, 0));
  EXPECT_EQ(bvh.triangles[0].corner_m[1], glm::vec4(3, 0, 2, 0));
  EXPECT_EQ(bvh.triangles[0].corner_m[2], glm::vec4(0, 5, 2, 1));
}

// A grid that begins so little beside 0 that differences of double do not show it: places on whole
// steps are then just outside them.
TEST(Bvh, PlanesHoldWhatDoubleCannotTellFromThem) {
  for (const float begin : {1e-25f, -1e-25f}) {
    std::array<gpu::Box, gpu::kBvhWidth> box;
    box[0].add(glm::vec3(begin));
    box[0].add(glm::vec3(200.0f));  // steps of 1 m
    box[1].add(glm::vec3(1.0f));
    box[1].add(glm::vec3(2.0f));
    gpu::BvhNode node{};
    gpu::set_boxes(node, box, gpu::least_step_m(200.0f));
    ASSERT_EQ(step_m(node, 0), 1.0);
    EXPECT_EQ(node.low[0][1], begin > 0.0f ? 0 : 1);
    EXPECT_EQ(node.high[0][1], begin > 0.0f ? 2 : 3);
  }
}

// Boxes of all sizes, some flat, some a point, near the origin and far from it.
TEST(Bvh, PlanesInBytesHoldTheBoxes) {
  for (std::uint64_t trial = 0; trial < 20'000; ++trial) {
    const calc::RandomKey key = calc::RandomKey(31).with(trial);
    const double size = std::pow(10.0, 14.0 * key.with(0).uniform() - 7.0);
    const double away = size * std::pow(10.0, 9.0 * key.with(1).uniform() - 3.0);
    std::array<gpu::Box, gpu::kBvhWidth> box;
    float largest = 0.0f;
    gpu::Box all;
    for (std::uint64_t slot = 0; slot < gpu::kBvhWidth; ++slot) {
      const calc::RandomKey own = key.with(2).with(slot);
      if (own.with(0).uniform() < 0.1 && slot > 0) continue;  // empty
      glm::dvec3 low, extent;
      for (int axis = 0; axis < 3; ++axis) {
        const calc::RandomKey along = own.with(static_cast<std::uint64_t>(axis) + 1);
        low[axis] = away + size * along.with(0).uniform();
        extent[axis] = along.with(1).uniform() < 0.2
                           ? 0.0
                           : size * std::pow(10.0, -8.0 * along.with(2).uniform());
        if (along.with(3).uniform() < 0.1) low[axis] = away;
      }
      box[slot].add(glm::vec3(low));
      box[slot].add(glm::vec3(low + extent));
      all.add(box[slot]);
      for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(box[slot].low[axis]), box[slot].high[axis]});
      }
    }
    gpu::BvhNode node{};
    const float least_m = gpu::least_step_m(largest);
    gpu::set_boxes(node, box, least_m);
    for (std::size_t slot = 0; slot < gpu::kBvhWidth; ++slot) {
      if (box[slot].is_empty()) continue;
      ASSERT_TRUE(holds(node, slot, box[slot].low) && holds(node, slot, box[slot].high)) << trial;
      for (std::size_t axis = 0; axis < 3; ++axis) {  // and no more than that
        const int a = static_cast<int>(axis);
        const double step = step_m(node, axis);
        ASSERT_LT(compare(box[slot].low[a], node.low_m[axis], node.low[axis][slot] + 1.0, step), 0);
        ASSERT_GT(compare(box[slot].high[a], node.low_m[axis], node.high[axis][slot] - 1.0, step),
                  0);
        if (step > static_cast<double>(least_m)) {
          ASSERT_GT(compare(all.high[a], node.low_m[axis], 255.0, 0.5 * step), 0) << trial;
        }
      }
    }
  }
}

}  // namespace
}  // namespace bvh_test
