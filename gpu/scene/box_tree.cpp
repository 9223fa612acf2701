#include "gpu/scene/box_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace gpu {
namespace {

constexpr std::size_t kBins = 16;
constexpr std::size_t kWorthATask = 4096;

struct Item {
  Box box;
  glm::vec3 middle;
  std::uint32_t triangle;
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
Split best_split(std::span<const Item> items, std::size_t most_per_leaf, const Box& box,
                 const Box& middles) {
  float least = items.size() <= most_per_leaf ? box.area() * static_cast<float>(items.size() - 1)
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

// Subtrees of n items have room for the 2n - 1 nodes that they need at most, so that threads can
// build them side by side.
class Builder {
 public:
  Builder(std::vector<Item>& items, std::size_t most_per_leaf, std::vector<BoxTree::Node>& nodes)
      : items_(items), most_per_leaf_(most_per_leaf), nodes_(nodes) {}

  void build(std::size_t node, std::size_t first, std::size_t count, int depth) {
    Box box, middles;
    for (std::size_t i = first; i < first + count; ++i) {
      box.add(items_[i].box);
      middles.add(items_[i].middle);
    }
    nodes_[node] = {box, first, count, 0, 0};
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
    nodes_[node].height = 1 + std::max(nodes_[node + 1].height, nodes_[second].height);
  }

 private:
  // Orders the items so that the first ones belong to the first child; their number, 0 = a leaf.
  std::size_t divide(std::size_t first, std::size_t count, const Box& box, const Box& middles,
                     int depth) {
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    // Where halves by number reach the most height just so, they must be taken.
    const auto halvings = static_cast<int>(std::bit_width(count - 1));
    const Split split = depth + halvings < BoxTree::kMostHeight
                            ? best_split({begin, end}, most_per_leaf_, box, middles)
                            : Split{};
    if (split.axis < 0) return count <= most_per_leaf_ ? 0 : count / 2;
    const auto middle = std::stable_partition(
        begin, end, [&](const Item& item) { return split.bin_of(item.middle) < split.bin; });
    return static_cast<std::size_t>(middle - begin);
  }

  std::vector<Item>& items_;
  std::size_t most_per_leaf_;
  std::vector<BoxTree::Node>& nodes_;
};

std::vector<Item> items_of(const calc::PreparedScene& scene) {
  std::vector<Item> items(scene.triangle.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (int k = 0; k < 3; ++k) items[i].box.add(scene.vertex_m[scene.triangle[i][k]]);
    items[i].middle = items[i].box.middle();
    items[i].triangle = static_cast<std::uint32_t>(i);
  }
  return items;
}

}  // namespace

BoxTree build_box_tree(const calc::PreparedScene& scene, std::size_t most_per_leaf) {
  BoxTree tree;
  std::vector<Item> items = items_of(scene);
  if (items.empty()) return tree;
  tree.nodes.resize(2 * items.size() - 1);
  Builder(items, most_per_leaf, tree.nodes).build(0, 0, items.size(), 0);
  tree.order.reserve(items.size());
  for (const Item& item : items) tree.order.push_back(item.triangle);
  return tree;
}

}  // namespace gpu
