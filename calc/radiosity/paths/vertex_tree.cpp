#include "calc/radiosity/paths/vertex_tree.h"

#include "calc/base/elementary.h"
#include "calc/radiosity/sampling/radix_sort.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace calc {
namespace {

// Fewer vertices say too little about their density.
constexpr std::uint32_t kDensityCount = 16;

constexpr int kBitsPerAxis = 10;  // a thousandth of the scene's extent
constexpr int kFacingShift = 3 * kBitsPerAxis;
constexpr int kChannelShift = kFacingShift + 3;

// Bits of a 10-bit number moved to every third place.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  return (x | (x << 2)) & 0x09249249u;
}

// 0 to 5: largest component of the normal and its sign.
std::uint64_t facing(const glm::vec3& n) {
  const glm::vec3 a = glm::abs(n);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : (a.y >= a.z ? 1 : 2);
  return static_cast<std::uint64_t>(2 * axis + (n[axis] < 0.0f ? 1 : 0));
}

std::vector<KeyedIndex> sort_keys(const LightVertices& vertices) {
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high(-std::numeric_limits<float>::max());
  for (const LightVertex& v : vertices) {
    low = glm::min(low, v.position_m);
    high = glm::max(high, v.position_m);
  }
  const glm::vec3 size = high - low;
  const float extent = std::max({size.x, size.y, size.z});
  // All at one place are in one cell: a quotient beyond float times 0 would be no number.
  constexpr float kOnePlace_m = 1e-30f;
  const float scale =
      extent > kOnePlace_m ? static_cast<float>((1 << kBitsPerAxis) - 1) / extent : 0.0f;
  std::vector<KeyedIndex> keys(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const LightVertex& v = vertices[i];
    const glm::vec3 cell = (v.position_m - low) * scale;
    const std::uint32_t morton = spread_bits(static_cast<std::uint32_t>(cell.x)) |
                                 (spread_bits(static_cast<std::uint32_t>(cell.y)) << 1) |
                                 (spread_bits(static_cast<std::uint32_t>(cell.z)) << 2);
    keys[i] = {
        (std::uint64_t{v.channel} << kChannelShift) | (facing(v.normal) << kFacingShift) | morton,
        static_cast<std::uint32_t>(i)};
  }
  return keys;
}

// First index in first + 1 .. last - 1 at which the highest bit that differs within the range is
// set; the middle if all keys are equal.
std::uint32_t split_of(const std::vector<KeyedIndex>& keys, std::uint32_t first,
                       std::uint32_t last) {
  const std::uint64_t difference = keys[first].key ^ keys[last - 1].key;
  if (difference == 0) return first + (last - first) / 2;
  const std::uint64_t bit = std::bit_floor(difference);
  const auto begin = keys.begin() + first;
  const auto found = std::partition_point(
      begin, keys.begin() + last, [bit](const KeyedIndex& k) { return (k.key & bit) == 0; });
  return first + static_cast<std::uint32_t>(found - begin);
}

void set_box(VertexNode& node, const glm::vec3& low, const glm::vec3& high) {
  node.centre_m = 0.5f * (low + high);
  node.half_m = 0.5f * (high - low);
  node.radius_m = glm::length(node.half_m);
}

void summarise_leaf(VertexNode& node, const LightVertices& vertices) {
  const LightVertex& vertex = vertices[node.first];
  node.flux_lm = vertex.flux_lm;
  node.centre_m = vertex.position_m;
  node.axis = vertex.normal;
}

void summarise_pair(VertexNode& node, const VertexNode& a, const VertexNode& b) {
  node.flux_lm = a.flux_lm + b.flux_lm;
  set_box(node, glm::min(a.centre_m - a.half_m, b.centre_m - b.half_m),
          glm::max(a.centre_m + a.half_m, b.centre_m + b.half_m));
  const glm::vec3 sum =
      a.axis * static_cast<float>(a.size()) + b.axis * static_cast<float>(b.size());
  const float length = glm::length(sum);
  const auto widest = [&](const VertexNode& part) {
    if (part.cos_spread <= -1.0f) return calc::acos(-1.0f);
    return calc::acos(std::clamp(glm::dot(node.axis, part.axis), -1.0f, 1.0f)) +
           calc::acos(std::clamp(part.cos_spread, -1.0f, 1.0f));
  };
  if (length < 1e-3f) {
    node.cos_spread = -1.0f;
    return;
  }
  node.axis = sum / length;
  if (a.axis == b.axis) {  // one flat surface, the usual case
    node.cos_spread = std::min(a.cos_spread, b.cos_spread);
    return;
  }
  node.cos_spread = calc::cos(std::min(std::max(widest(a), widest(b)), calc::acos(-1.0f)));
}

float density(const VertexNode& node) {
  constexpr float kPi_f = std::numbers::pi_v<float>;
  const float area = kPi_f * node.radius_m * node.radius_m;
  return static_cast<float>(node.size()) / std::max(area, 1e-6f);
}

}  // namespace

VertexTree::VertexTree(LightVertices vertices, std::size_t channels) {
  if (vertices.empty()) return;
  std::vector<KeyedIndex> keys = sort_keys(vertices);
  radix_sort(keys, kChannelShift + static_cast<int>(std::bit_width(channels)));
  vertices_.reserve(vertices.size());
  flux_before_lm_.reserve(vertices.size() + 1);
  flux_before_lm_.push_back(0.0);
  for (const KeyedIndex& k : keys) {
    vertices_.push_back(vertices[k.index]);
    flux_before_lm_.push_back(flux_before_lm_.back() +
                              static_cast<double>(vertices_.back().flux_lm));
  }

  const auto count = static_cast<std::uint32_t>(vertices_.size());
  nodes_.reserve(vertices_.size());
  for (std::uint32_t first = 0; first < count;) {
    const std::uint32_t channel = vertices_[first].channel;
    std::uint32_t last = first;
    while (last < count && vertices_[last].channel == channel) ++last;
    VertexNode root;
    root.first = first;
    root.last = last;
    root.channel = channel;
    roots_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back(root);
    first = last;
  }
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (nodes_[n].size() == 1) continue;
    const VertexNode parent = nodes_[n];
    VertexNode left, right;
    left.channel = right.channel = parent.channel;
    left.first = parent.first;
    left.last = right.first = split_of(keys, parent.first, parent.last);
    right.last = parent.last;
    nodes_[n].child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(left);
    nodes_.push_back(right);
  }
  // Children come after their parents.
  for (auto n = nodes_.size(); n-- > 0;) {
    VertexNode& node = nodes_[n];
    if (node.child == 0) {
      summarise_leaf(node, vertices_);
    } else {
      summarise_pair(node, nodes_[node.child], nodes_[node.child + 1]);
    }
  }
  for (const std::uint32_t root : roots_) nodes_[root].per_m2 = density(nodes_[root]);
  for (const VertexNode& node : nodes_) {
    if (node.child == 0) continue;
    for (VertexNode* part : {&nodes_[node.child], &nodes_[node.child + 1]}) {
      part->per_m2 = part->size() < kDensityCount ? node.per_m2 : density(*part);
    }
  }
}

std::uint32_t VertexTree::vertex_at(std::uint32_t first, std::uint32_t last, double share) const {
  const double wanted =
      flux_before_lm_[first] + share * (flux_before_lm_[last] - flux_before_lm_[first]);
  std::uint32_t low = first;  // flux before it <= wanted
  for (std::uint32_t size = last - first; size > 1;) {
    const std::uint32_t half = size / 2;
    low += flux_before_lm_[low + half] <= wanted ? half : 0;  // no branch to mispredict
    size -= half;
  }
  return low;
}

}  // namespace calc
