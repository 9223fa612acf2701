#include "calc/radiosity/cut.h"

#include "calc/radiosity/node_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace calc {
namespace {

// Float rounding must not turn "just in front" into "behind".
constexpr float kRelativeSlack = 1e-5f;

// The bound is kappa times the density of first reflections, about a third of all vertices.
constexpr float kBoundPerDensity = 0.003f;

bool is_behind(const ReceiverTile& tile, const VertexNode& node) {
  if (tile.axis == glm::vec3(0.0f)) return false;
  const float highest = glm::dot(tile.axis, node.centre_m) + node.radius_m;
  const float slack =
      kRelativeSlack * (std::abs(tile.lowest_m) + glm::length(node.centre_m) + node.radius_m);
  return highest + slack < tile.lowest_m;
}

// No direction from the node to the tile lies within 90 degrees of any of its normals.
bool faces_away(const ReceiverTile& tile, const VertexNode& node) {
  if (node.cos_spread <= 0.0f) return false;
  const glm::vec3 to_tile = tile.centre_m - node.centre_m;
  const float distance = glm::length(to_tile);
  const float reach = node.radius_m + tile.radius_m;
  const float cosine = glm::dot(node.axis, to_tile);
  if (cosine >= 0.0f) return false;
  if (node.cos_spread >= 1.0f - 1e-6f) {  // flat: a plain distance to the plane
    return cosine + reach + kRelativeSlack * (distance + glm::length(node.centre_m)) < 0.0f;
  }
  if (distance <= reach) return false;
  // angle(axis, to_tile) > 90 degrees + spread + angle that both spheres take up
  const float spread = std::acos(std::min(1.0f, node.cos_spread));
  const float sphere = std::asin(reach / distance);
  return std::acos(std::clamp(cosine / distance, -1.0f, 1.0f)) >
         std::acos(0.0f) + spread + sphere + 1e-3f;
}

float bound_of(const VertexNode& node, float smallest_bound_per_m2) {
  return std::max(smallest_bound_per_m2, kBoundPerDensity * node.per_m2);
}

// How far the node's contribution may vary over its vertices: flux times the largest kernel, times
// the share of it that position and normals leave open.
float error_of(const ReceiverTile& tile, const VertexNode& node, float smallest_bound_per_m2) {
  if (node.child == 0) return 0.0f;
  const float distance = glm::length(node.centre_m - tile.centre_m) + tile.softening_m;
  const float gap = std::max(0.0f, distance - tile.radius_m - node.radius_m);
  const float largest = std::min(1.0f / (gap * gap + 1e-12f), bound_of(node, smallest_bound_per_m2));
  const float r2 = node.radius_m * node.radius_m;
  const float open = r2 / (gap * gap + r2 + 1e-12f) + (1.0f - node.cos_spread);
  return node.flux_lm * largest * open;
}

}  // namespace

ReceiverTile tile_of(std::span<const Receiver> receivers) {
  glm::dvec3 low = receivers.front().position_m;
  glm::dvec3 high = low;
  bool is_flat = true;
  for (const Receiver& r : receivers) {
    low = glm::min(low, r.position_m);
    high = glm::max(high, r.position_m);
    is_flat = is_flat && has_back(r.kernel) && r.axis == receivers.front().axis;
  }
  ReceiverTile tile;
  tile.centre_m = glm::vec3(0.5 * (low + high));
  tile.radius_m = static_cast<float>(0.5 * glm::length(high - low)) * (1.0f + kRelativeSlack);
  if (!is_flat) return tile;
  tile.axis = glm::vec3(receivers.front().axis);
  tile.lowest_m = std::numeric_limits<float>::max();
  for (const Receiver& r : receivers) {
    tile.lowest_m = std::min(tile.lowest_m, glm::dot(tile.axis, glm::vec3(r.position_m)));
  }
  return tile;
}

void Cut::build(const VertexTree& tree, const ReceiverTile& tile, std::size_t size,
                float smallest_bound_per_m2, bool leave_out_hidden) {
  for (auto* ids : {&first_, &count_, &channel_}) ids->clear();
  for (auto* v : {&flux_lm_, &radius2_m2_, &bound_per_m2_, &centre_x_, &centre_y_, &centre_z_})
    v->clear();
  const std::span<const VertexNode> nodes = tree.nodes();
  const auto is_hidden = [&](const VertexNode& node) {
    return leave_out_hidden && (is_behind(tile, node) || faces_away(tile, node));
  };
  // A heap of (error, node); equal errors: the lower node first, so that nothing is left to chance.
  struct Entry {
    float error;
    std::uint32_t node;
    bool operator<(const Entry& other) const {
      return error < other.error || (error == other.error && node > other.node);
    }
  };
  thread_local std::vector<Entry> heap;
  heap.clear();
  const auto push = [&](std::uint32_t n) {
    if (is_hidden(nodes[n])) return;
    heap.push_back({error_of(tile, nodes[n], smallest_bound_per_m2), n});
    std::push_heap(heap.begin(), heap.end());
  };
  for (const std::uint32_t root : tree.roots()) push(root);
  while (!heap.empty() && heap.size() < size && heap.front().error > 0.0f) {
    const std::uint32_t child = nodes[heap.front().node].child;
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    push(child);
    push(child + 1);
  }
  // In pool order, so that draws walk through memory forwards.
  std::sort(heap.begin(), heap.end(), [&](const Entry& a, const Entry& b) {
    return nodes[a.node].first < nodes[b.node].first;
  });
  for (const Entry& e : heap) {
    const VertexNode& node = nodes[e.node];
    first_.push_back(node.first);
    count_.push_back(node.size());
    channel_.push_back(node.channel);
    flux_lm_.push_back(node.flux_lm);
    radius2_m2_.push_back(node.radius_m * node.radius_m);
    bound_per_m2_.push_back(bound_of(node, smallest_bound_per_m2));
    centre_x_.push_back(node.centre_m.x);
    centre_y_.push_back(node.centre_m.y);
    centre_z_.push_back(node.centre_m.z);
  }

  const std::size_t count = first_.size();
  for (auto* v : {&x_, &y_, &z_, &nx_, &ny_, &nz_}) v->resize(kRepresentatives * count);
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t m = 0; m < kRepresentatives; ++m) {
      // Evenly spaced in the node; a node of fewer vertices repeats some.
      const std::size_t offset = (2 * m + 1) * count_[c] / (2 * kRepresentatives);
      const LightVertex& v = tree.vertices()[first_[c] + offset];
      const std::size_t k = m * count + c;
      x_[k] = v.position_m.x;
      y_[k] = v.position_m.y;
      z_[k] = v.position_m.z;
      nx_[k] = v.normal.x;
      ny_[k] = v.normal.y;
      nz_[k] = v.normal.z;
    }
  }
}

void Cut::weigh(const Receiver& receiver, std::vector<float>& probability) const {
  const CutArrays arrays{
      size(),           flux_lm_.data(),  radius2_m2_.data(), bound_per_m2_.data(),
      centre_x_.data(), centre_y_.data(), centre_z_.data(),   x_.data(),
      y_.data(),        z_.data(),        nx_.data(),         ny_.data(),
      nz_.data()};
  const glm::vec3 p(receiver.position_m);
  const glm::vec3 n(receiver.axis);
  probability.resize(size());
  if (receiver.kernel == ReceiverKernel::planar) {
    weigh_planar(arrays, &p.x, &n.x, probability.data());
  } else {
    weigh_round(arrays, &p.x, probability.data());
  }
}

}  // namespace calc
