#include "gpu/bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace gpu {
namespace {

constexpr std::size_t kBins = 16;
constexpr std::size_t kMostPerLeaf = 4;
static_assert(kMostPerLeaf < kLeafStep);
// Below this depth halves by number keep the tree from growing into a list.
constexpr int kDeepest = 48;
constexpr std::size_t kWorthATask = 4096;

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};

  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  // Half of it; 0 if nothing is inside.
  float area() const {
    const glm::vec3 d = glm::max(high - low, glm::vec3(0.0f));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

struct Item {
  Box box;
  glm::vec3 middle;
  std::uint32_t triangle;
};

// Subtrees of n items have room for the 2n - 1 nodes that they need at most, so that threads can
// build them side by side; gaps go when the tree is flattened.
struct BuildNode {
  Box box;
  std::size_t first = 0, count = 0;  // of items
  std::size_t second_child = 0;      // 0 = leaf; the first child follows the node
};

struct Split {
  int axis = -1;  // -1 = none pays
  std::size_t bin = 0;
  float begin = 0.0f, bins_per_m = 0.0f;

  std::size_t bin_of(const glm::vec3& middle) const {
    const float place = (middle[axis] - begin) * bins_per_m;
    return std::min(static_cast<std::size_t>(std::max(0.0f, place)), kBins - 1);
  }
};

// The least cost of all planes between bins, if it is less than that of one leaf or if there are
// too many items for one.
Split best_split(std::span<const Item> items, const Box& box, const Box& middles) {
  float least = items.size() <= kMostPerLeaf ? box.area() * static_cast<float>(items.size() - 1)
                                             : std::numeric_limits<float>::max();
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const float width = middles.high[axis] - middles.low[axis];
    Split split{axis, 0, middles.low[axis], static_cast<float>(kBins) / width};
    if (!(width > 0.0f) || !(split.bins_per_m < std::numeric_limits<float>::max())) continue;
    std::array<Box, kBins> bin_box;
    std::array<std::size_t, kBins> bin_count{};
    for (const Item& item : items) {
      const std::size_t b = split.bin_of(item.middle);
      bin_box[b].add(item.box);
      ++bin_count[b];
    }
    std::array<float, kBins> cost_below{};
    Box below;
    std::size_t count = 0;
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      below.add(bin_box[b]);
      count += bin_count[b];
      cost_below[b + 1] = below.area() * static_cast<float>(count);
    }
    Box above;
    count = 0;
    for (std::size_t b = kBins - 1; b > 0; --b) {
      above.add(bin_box[b]);
      count += bin_count[b];
      const float cost = cost_below[b] + above.area() * static_cast<float>(count);
      if (count == 0 || count == items.size() || !(cost < least)) continue;
      least = cost;
      best = split;
      best.bin = b;
    }
  }
  return best;
}

class Builder {
 public:
  Builder(std::vector<Item>& items, std::vector<BuildNode>& nodes) : items_(items), nodes_(nodes) {}

  void build(std::size_t node, std::size_t first, std::size_t count, int depth) {
    Box box, middles;
    for (std::size_t i = first; i < first + count; ++i) {
      box.add(items_[i].box);
      middles.add(items_[i].middle);
    }
    nodes_[node] = {box, first, count, 0};
    if (count <= 1) return;
    const std::size_t below = divide(first, count, box, middles, depth);
    if (below == 0) return;
    const std::size_t second = node + 2 * below;
    nodes_[node].second_child = second;
    const auto build_first = [&] { build(node + 1, first, below, depth + 1); };
    const auto build_second = [&] { build(second, first + below, count - below, depth + 1); };
    if (count > kWorthATask) {
      tbb::parallel_invoke(build_first, build_second);
    } else {
      build_first();
      build_second();
    }
  }

 private:
  // Orders the items so that the first ones belong to the first child; their number, 0 = a leaf.
  std::size_t divide(std::size_t first, std::size_t count, const Box& box, const Box& middles,
                     int depth) {
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    const Split split = depth < kDeepest ? best_split({begin, end}, box, middles) : Split{};
    if (split.axis < 0) return count <= kMostPerLeaf ? 0 : count / 2;
    const auto middle = std::stable_partition(
        begin, end, [&](const Item& item) { return split.bin_of(item.middle) < split.bin; });
    return static_cast<std::size_t>(middle - begin);
  }

  std::vector<Item>& items_;
  std::vector<BuildNode>& nodes_;
};

std::vector<Item> items_of(const calc::PreparedScene& scene) {
  std::vector<Item> items(scene.triangle.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (int k = 0; k < 3; ++k) items[i].box.add(scene.vertex_m[scene.triangle[i][k]]);
    items[i].middle = 0.5f * items[i].box.low + 0.5f * items[i].box.high;
    items[i].triangle = static_cast<std::uint32_t>(i);
  }
  return items;
}

BvhTriangle triangle_of(const calc::PreparedScene& scene, std::uint32_t triangle) {
  const glm::uvec3 corner = scene.triangle[triangle];
  const glm::vec3 a = scene.vertex_m[corner.x], b = scene.vertex_m[corner.y],
                  c = scene.vertex_m[corner.z];
  const glm::vec3 normal(
      glm::normalize(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a))));
  return {{glm::vec4(a, normal.x), glm::vec4(b, normal.y), glm::vec4(c, normal.z)}};
}

// Closes the gaps. Returns nothing: `flat` grows by the subtree.
void flatten(const std::vector<BuildNode>& nodes, std::size_t node, std::vector<BvhNode>& flat) {
  const BuildNode& from = nodes[node];
  const std::size_t place = flat.size();
  const bool is_leaf = from.second_child == 0;
  const auto leaf = is_leaf ? static_cast<std::uint32_t>(from.first * kLeafStep + from.count) : 0u;
  flat.push_back({{from.box.low.x, from.box.low.y, from.box.low.z},
                  0,
                  {from.box.high.x, from.box.high.y, from.box.high.z},
                  leaf});
  if (!is_leaf) {
    flatten(nodes, node + 1, flat);
    flatten(nodes, from.second_child, flat);
  }
  flat[place].next = static_cast<std::uint32_t>(flat.size());
}

}  // namespace

Bvh build_bvh(const calc::PreparedScene& scene) {
  Bvh bvh;
  std::vector<Item> items = items_of(scene);
  if (items.empty()) return bvh;
  std::vector<BuildNode> nodes(2 * items.size() - 1);
  Builder(items, nodes).build(0, 0, items.size(), 0);
  flatten(nodes, 0, bvh.nodes);
  bvh.triangles.reserve(items.size());
  bvh.order.reserve(items.size());
  for (const Item& item : items) {
    bvh.triangles.push_back(triangle_of(scene, item.triangle));
    bvh.order.push_back(item.triangle);
  }
  return bvh;
}

}  // namespace gpu
