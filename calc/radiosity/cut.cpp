#include "calc/radiosity/cut.h"

#include "calc/base/elementary.h"
#include "calc/radiosity/node_terms.h"
#include "calc/radiosity/node_weights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace calc {
namespace {

// Float rounding must not turn "just in front" into "behind".
constexpr float kRelativeSlack = 1e-5f;

enum : std::uint8_t { kUnseen, kTaken, kOpened, kHidden };

// Exponent and two bits of the mantissa of a float, from 2^-40 to 2^40.
constexpr int kLevels = 4 * 80;
int level_of(float error) {
  const int level = static_cast<int>(std::bit_cast<std::uint32_t>(error) >> 21) - 4 * (127 - 40);
  return std::clamp(level, 0, kLevels - 1);
}

// Geometry of a node as seen from a tile.
struct NodeView {
  glm::vec3 to_tile;
  float distance;  // between centres

  NodeView(const ReceiverTile& tile, const VertexNode& node)
      : to_tile(tile.centre_m - node.centre_m), distance(glm::length(to_tile)) {}
};

bool is_behind(const ReceiverTile& tile, const VertexNode& node) {
  const float highest =
      glm::dot(tile.axis, node.centre_m) + glm::dot(glm::abs(tile.axis), node.half_m);
  return highest + tile.slack_m < tile.lowest_m;
}

// No direction from the node to the tile lies within 90 degrees of any of its normals.
bool faces_away(const ReceiverTile& tile, const VertexNode& node, const NodeView& view) {
  const float cosine = glm::dot(node.axis, view.to_tile);
  if (cosine >= 0.0f || node.cos_spread <= 0.0f) return false;
  const float reach = node.radius_m + tile.radius_m;
  if (node.cos_spread >= 1.0f - 1e-6f) {  // one normal: a plain distance to the plane
    return cosine + glm::dot(glm::abs(node.axis), node.half_m) + tile.radius_m + tile.slack_m <
           0.0f;
  }
  if (view.distance <= reach) return false;
  // angle(axis, to_tile) > 90 degrees + spread + angle that both spheres take up
  const float spread = calc::acos(std::min(1.0f, node.cos_spread));
  const float sphere = calc::asin(reach / view.distance);
  return calc::acos(std::clamp(cosine / view.distance, -1.0f, 1.0f)) >
         calc::acos(0.0f) + spread + sphere + 1e-3f;
}

float bound_of(const VertexNode& node, float smallest_bound_per_m2) {
  return node_terms::node_bound_per_m2(smallest_bound_per_m2, node.per_m2);
}

// How far the node's contribution may vary over its vertices: flux times the largest kernel, times
// the share of it that position and normals leave open.
float error_of(const ReceiverTile& tile, const VertexNode& node, const NodeView& view,
               float smallest_bound_per_m2) {
  if (node.child == 0) return 0.0f;
  const float gap =
      std::max(0.0f, view.distance + tile.softening_m - tile.radius_m - node.radius_m);
  const float gap2 = gap * gap + 1e-12f;
  const float r2 = node.radius_m * node.radius_m;
  const float largest = std::min(1.0f / gap2, bound_of(node, smallest_bound_per_m2));
  return node.flux_lm * largest * (r2 / (gap2 + r2) + (1.0f - node.cos_spread));
}

}  // namespace

ReceiverTile tile_of(std::span<const Receiver> receivers, double extent_m) {
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
  tile.slack_m = static_cast<float>(extent_m) * kRelativeSlack;
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
  open_nodes(tree, tile, size, smallest_bound_per_m2, leave_out_hidden);
  resize(taken_);
  collect(tree, smallest_bound_per_m2);
}

void Cut::open_nodes(const VertexTree& tree, const ReceiverTile& tile, std::size_t size,
                     float smallest_bound_per_m2, bool leave_out_hidden) {
  const std::span<const VertexNode> nodes = tree.nodes();
  state_.resize(std::max(state_.size(), nodes.size()), kUnseen);
  queue_.resize(kLevels);
  const bool has_axis = leave_out_hidden && tile.axis != glm::vec3(0.0f);
  std::size_t count = 0;
  int highest = 0;
  const auto add = [&](std::uint32_t n) {
    touched_.push_back(n);
    const VertexNode& node = nodes[n];
    if (has_axis && is_behind(tile, node)) {
      state_[n] = kHidden;
      return;
    }
    const NodeView view(tile, node);
    if (leave_out_hidden && faces_away(tile, node, view)) {
      state_[n] = kHidden;
      return;
    }
    state_[n] = kTaken;
    ++count;
    const float error = error_of(tile, node, view, smallest_bound_per_m2);
    if (!(error > 0.0f)) return;
    const int level = level_of(error);
    highest = std::max(highest, level);
    queue_[static_cast<std::size_t>(level)].push_back(n);
  };
  for (const std::uint32_t root : tree.roots()) add(root);
  for (; highest >= 0; --highest) {
    auto& best = queue_[static_cast<std::size_t>(highest)];
    bool rises = false;  // a part may have a larger error than the whole
    while (!best.empty() && count < size && !rises) {
      const std::uint32_t n = best.back();
      best.pop_back();
      state_[n] = kOpened;
      --count;
      const int before = highest;
      add(nodes[n].child);
      add(nodes[n].child + 1);
      rises = highest > before;
    }
    if (count >= size) break;
    if (rises) ++highest;  // the loop steps down to it
  }
  for (auto& level : queue_) level.clear();
  taken_ = count;
}

void Cut::resize(std::size_t size) {
  for (auto* v : {&node_, &first_, &count_}) v->resize(size);
  for (auto* v : {&flux_lm_, &radius_m_, &bound_per_m2_, &centre_x_, &centre_y_, &centre_z_, &x_,
                  &y_, &z_, &nx_, &ny_, &nz_}) {
    v->resize(size);
  }
}

// Calls take(n, node) for every node n that was taken, in pool order, and forgets which they are.
template <class Take>
void Cut::visit_taken(const VertexTree& tree, std::vector<ChannelRange>& channels,
                      const Take& take) {
  std::uint32_t c = 0;
  for (const std::uint32_t root : tree.roots()) {
    const std::uint32_t begin = c;
    stack_.assign(1, root);
    while (!stack_.empty()) {
      const std::uint32_t n = stack_.back();
      const VertexNode& node = tree.nodes()[n];
      const std::uint8_t state = state_[n];
      stack_.pop_back();
      if (state == kOpened) {
        stack_.push_back(node.child + 1);
        stack_.push_back(node.child);
      }
      if (state != kTaken) continue;
      take(n, node);
      ++c;
    }
    if (c > begin) channels.push_back({begin, c});
  }
  for (const std::uint32_t n : touched_) state_[n] = kUnseen;
  touched_.clear();
}

void Cut::select(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request,
                 std::vector<std::uint32_t>& nodes, std::vector<ChannelRange>& channels) {
  open_nodes(tree, tile, request.nodes, request.smallest_bound_per_m2, request.leave_out_hidden);
  visit_taken(tree, channels, [&](std::uint32_t n, const VertexNode&) { nodes.push_back(n); });
}

void Cut::collect(const VertexTree& tree, float smallest_bound_per_m2) {
  channel_.clear();
  std::size_t c = 0;
  visit_taken(tree, channel_, [&](std::uint32_t n, const VertexNode& node) {
    node_[c] = n;
    first_[c] = node.first;
    count_[c] = node.size();
    flux_lm_[c] = node.flux_lm;
    radius_m_[c] = node.radius_m;
    bound_per_m2_[c] = bound_of(node, smallest_bound_per_m2);
    centre_x_[c] = node.centre_m.x;
    centre_y_[c] = node.centre_m.y;
    centre_z_[c] = node.centre_m.z;
    const LightVertex& v = tree.vertices()[node.representative()];
    x_[c] = v.position_m.x;
    y_[c] = v.position_m.y;
    z_[c] = v.position_m.z;
    nx_[c] = v.normal.x;
    ny_[c] = v.normal.y;
    nz_[c] = v.normal.z;
    ++c;
  });
}

void Cut::weigh(const Receiver& receiver, std::vector<float>& probability) const {
  const CutArrays arrays{size(),           flux_lm_.data(),  radius_m_.data(), bound_per_m2_.data(),
                         centre_x_.data(), centre_y_.data(), centre_z_.data(), x_.data(),
                         y_.data(),        z_.data(),        nx_.data(),       ny_.data(),
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
