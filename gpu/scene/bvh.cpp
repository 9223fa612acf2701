#include "gpu/scene/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace gpu {
namespace {

constexpr double kMostSteps = 255.0;
constexpr int kExponentBias = 127;

// a - b is exactly value + rest: Knuth's two-sum.
struct Difference {
  double value, rest;
  Difference(double a, double b) : value(a - b) {
    const double of_b = a - value, of_a = value + of_b;
    rest = (a - of_a) - (b - of_b);
  }
};

// Whole steps from `begin` that do not reach beyond a place.
double steps_below(float place, float begin, double step) {
  const Difference way(static_cast<double>(place), static_cast<double>(begin));
  const double steps = std::floor(way.value / step);
  return steps * step == way.value && way.rest < 0.0 ? steps - 1.0 : steps;
}

// Whole steps from `begin` that reach a place.
double steps_above(float place, float begin, double step) {
  const Difference way(static_cast<double>(place), static_cast<double>(begin));
  const double steps = std::ceil(way.value / step);
  return steps * step == way.value && way.rest > 0.0 ? steps + 1.0 : steps;
}

double step_m(std::uint8_t exponent_bits) {
  return std::ldexp(1.0, int{exponent_bits} - kExponentBias);
}

// The finest step that reaches from one place to another.
std::uint8_t finest_step(float begin, float end, float least_step_m) {
  auto exponent = static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(least_step_m) >> 23);
  while (steps_above(end, begin, step_m(exponent)) > kMostSteps) ++exponent;
  return exponent;
}

// Puts children into slots so that they lie along the slots' directions, the best pair first.
class Slots {
 public:
  Slots(const std::vector<const BoxTree::Node*>& children, const glm::vec3& middle) {
    std::array<std::array<float, kBvhWidth>, kBvhWidth> gain{};
    for (std::size_t c = 0; c < children.size(); ++c) {
      const glm::vec3 off = children[c]->box.middle() - middle;
      for (std::size_t slot = 0; slot < kBvhWidth; ++slot) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const float along = off[static_cast<int>(axis)];
          gain[c][slot] += ((slot >> axis) & 1u) != 0 ? along : -along;
        }
      }
    }
    std::array<bool, kBvhWidth> has_slot{};
    for (std::size_t k = 0; k < children.size(); ++k) {
      std::size_t child = kBvhWidth, place = 0;
      for (std::size_t c = 0; c < children.size(); ++c) {
        for (std::size_t slot = 0; slot < kBvhWidth; ++slot) {
          if (has_slot[c] || at[slot] != nullptr) continue;
          if (child < kBvhWidth && !(gain[c][slot] > gain[child][place])) continue;
          child = c;
          place = slot;
        }
      }
      at[place] = children[child];
      has_slot[child] = true;
    }
  }

  std::array<const BoxTree::Node*, kBvhWidth> at{};  // nullptr = empty
};

BvhTriangle triangle_of(const calc::PreparedScene& scene, std::uint32_t triangle) {
  const glm::uvec3 corner = scene.triangle[triangle];
  const glm::vec3 a = scene.vertex_m[corner.x], b = scene.vertex_m[corner.y],
                  c = scene.vertex_m[corner.z];
  const glm::vec3 normal(
      glm::normalize(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a))));
  return {{glm::vec4(a, normal.x), glm::vec4(b, normal.y), glm::vec4(c, normal.z)}};
}

// Which nodes of a binary tree become children of one wide node, at the least cost of the whole:
// areas of boxes, times what it takes to search a node or to test a triangle. [Ylitie17, 3.1]
class Choice {
 public:
  explicit Choice(const BoxTree& tree) : tree_(tree), cost_(tree.nodes.size()) {
    for (std::size_t at = tree_.nodes.size(); at-- > 0;) find_costs(at);  // children come first
  }

  std::vector<const BoxTree::Node*> children_of(std::size_t at) const {
    std::vector<const BoxTree::Node*> children;
    split(at, kBvhWidth, children);
    return children;
  }

 private:
  // About as on llvmpipe, and as bytes that are fetched.
  static constexpr float kNodeCost = 1.0f, kTriangleCost = 0.5f;
  // Of a subtree as 1 to kBvhWidth trees at most, at [1] to [kBvhWidth].
  using Costs = std::array<float, kBvhWidth + 1>;

  void find_costs(std::size_t at) {
    const BoxTree::Node& node = tree_.nodes[at];
    if (node.count == 0) return;  // not in use
    Costs& cost = cost_[at];
    if (node.is_leaf()) {
      cost.fill(kTriangleCost * node.box.area() * static_cast<float>(node.count));
      return;
    }
    for (std::size_t trees = 2; trees <= kBvhWidth; ++trees) {
      cost[trees] = cost_of_split(at, trees, first_share(at, trees));
    }
    cost[1] = cost[kBvhWidth] + kNodeCost * node.box.area();
    for (std::size_t trees = 2; trees <= kBvhWidth; ++trees) {
      cost[trees] = std::min(cost[trees], cost[trees - 1]);
    }
  }

  float cost_of_split(std::size_t at, std::size_t trees, std::size_t first) const {
    return cost_[at + 1][first] + cost_[tree_.nodes[at].second_child][trees - first];
  }

  // Of so many trees, those that the first child becomes.
  std::size_t first_share(std::size_t at, std::size_t trees) const {
    std::size_t best = 1;
    for (std::size_t first = 2; first < trees; ++first) {
      if (cost_of_split(at, trees, first) < cost_of_split(at, trees, best)) best = first;
    }
    return best;
  }

  void split(std::size_t at, std::size_t trees, std::vector<const BoxTree::Node*>& children) const {
    const std::size_t first = first_share(at, trees);
    add(at + 1, first, children);
    add(tree_.nodes[at].second_child, trees - first, children);
  }

  void add(std::size_t at, std::size_t trees, std::vector<const BoxTree::Node*>& children) const {
    const Costs& cost = cost_[at];
    while (trees > 1 && cost[trees] == cost[trees - 1]) --trees;
    if (trees == 1) {
      children.push_back(&tree_.nodes[at]);
    } else {
      split(at, trees, children);
    }
  }

  const BoxTree& tree_;
  std::vector<Costs> cost_;
};

class Widener {
 public:
  Widener(const BoxTree& tree, float least_step_m, Bvh& bvh)
      : tree_(tree), choice_(tree), least_step_m_(least_step_m), bvh_(bvh) {}

  // Fills the node `to` from a subtree that is at most 3 * (kBvhLevels - level) high.
  void fill(std::size_t to, const BoxTree::Node& from, int level) {
    const Slots slots(children_of(from, level), from.box.middle());
    BvhNode node{};
    node.first_child = static_cast<std::uint32_t>(bvh_.nodes.size());
    node.first_triangle = static_cast<std::uint32_t>(bvh_.order.size());
    std::array<Box, kBvhWidth> box;
    std::size_t inner = 0;
    for (std::size_t slot = 0; slot < kBvhWidth; ++slot) {
      const BoxTree::Node* child = slots.at[slot];
      if (child == nullptr) continue;
      box[slot] = child->box;
      if (!child->is_leaf()) {
        node.inner = static_cast<std::uint8_t>(node.inner | (1u << slot));
        ++inner;
        continue;
      }
      node.triangles |= ((1u << child->count) - 1u) << (4 * slot);
      const auto first = tree_.order.begin() + static_cast<std::ptrdiff_t>(child->first);
      bvh_.order.insert(bvh_.order.end(), first, first + static_cast<std::ptrdiff_t>(child->count));
    }
    set_boxes(node, box, least_step_m_);
    bvh_.nodes[to] = node;
    bvh_.nodes.resize(bvh_.nodes.size() + inner);
    std::size_t place = node.first_child;
    for (const BoxTree::Node* child : slots.at) {
      if (child != nullptr && !child->is_leaf()) fill(place++, *child, level + 1);
    }
  }

 private:
  // Those below in the binary tree. What is too high for the levels that are left goes before
  // costs: it has at most eight nodes three levels down.
  std::vector<const BoxTree::Node*> children_of(const BoxTree::Node& from, int level) const {
    if (from.is_leaf()) return {&from};  // all of the scene
    const int most_height = 3 * (kBvhLevels - level - 1);
    const auto at = static_cast<std::size_t>(&from - tree_.nodes.data());
    std::vector<const BoxTree::Node*> children = choice_.children_of(at);
    const bool is_low =
        std::all_of(children.begin(), children.end(),
                    [&](const BoxTree::Node* child) { return child->height <= most_height; });
    return is_low ? children : highest_opened(from);
  }

  std::vector<const BoxTree::Node*> highest_opened(const BoxTree::Node& from) const {
    std::vector<const BoxTree::Node*> children{&from};
    while (children.size() < kBvhWidth) {
      const auto highest = std::max_element(
          children.begin(), children.end(),
          [](const BoxTree::Node* a, const BoxTree::Node* b) { return a->height < b->height; });
      const BoxTree::Node* opened = *highest;
      if (opened->is_leaf()) break;
      *highest = opened + 1;
      children.push_back(&tree_.nodes[opened->second_child]);
    }
    return children;
  }

  const BoxTree& tree_;
  Choice choice_;
  float least_step_m_;
  Bvh& bvh_;
};

}  // namespace

float least_step_m(float largest_coordinate_m) {
  constexpr int kLeastExponent = -100;  // no denormal number comes of it
  const int exponent = largest_coordinate_m > 0.0f ? std::ilogb(largest_coordinate_m) - 32 : 0;
  return std::ldexp(1.0f, std::max(exponent, kLeastExponent));
}

void set_boxes(BvhNode& node, const std::array<Box, kBvhWidth>& child, float least_step_m) {
  Box all;
  for (const Box& box : child) all.add(box);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const float begin = all.low[axis];
    node.low_m[a] = begin;
    node.step[a] = finest_step(begin, all.high[axis], least_step_m);
    const double step = step_m(node.step[a]);
    for (std::size_t slot = 0; slot < kBvhWidth; ++slot) {
      if (child[slot].is_empty()) {  // the shader does not ask whether it is met
        node.low[a][slot] = node.high[a][slot] = 0;
        continue;
      }
      node.low[a][slot] =
          static_cast<std::uint8_t>(steps_below(child[slot].low[axis], begin, step));
      node.high[a][slot] =
          static_cast<std::uint8_t>(steps_above(child[slot].high[axis], begin, step));
    }
  }
}

Bvh build_bvh(const calc::PreparedScene& scene) {
  Bvh bvh;
  const BoxTree tree = build_box_tree(scene, kMostPerLeaf);
  if (tree.nodes.empty()) return bvh;
  const Box& all = tree.nodes.front().box;
  const glm::vec3 farthest = glm::max(glm::abs(all.low), glm::abs(all.high));
  const float least = least_step_m(std::max(farthest.x, std::max(farthest.y, farthest.z)));
  bvh.order.reserve(scene.triangle.size());
  bvh.nodes.resize(1);
  Widener(tree, least, bvh).fill(0, tree.nodes.front(), 0);
  bvh.triangles.reserve(bvh.order.size());
  for (const std::uint32_t triangle : bvh.order) {
    bvh.triangles.push_back(triangle_of(scene, triangle));
  }
  return bvh;
}

}  // namespace gpu
