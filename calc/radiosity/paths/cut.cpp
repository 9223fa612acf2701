#include "calc/radiosity/paths/cut.h"

#include "calc/radiosity/paths/node_weights.h"
#include "calc/radiosity/terms/node_terms.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace calc {
namespace {

// Float rounding must not turn "just in front" into "behind".
constexpr float kRelativeSlack = 1e-5f;

enum : std::uint8_t { kUnseen, kTaken, kOpened, kHidden };

// A node that can light nothing of the tile.
constexpr int kHiddenStep = -2;

// Of a node's error as seen from a tile, see cut_terms.glsl.
int step_of(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request,
            std::uint32_t n) {
  const VertexNode& node = tree.nodes()[n];
  const glm::vec3 &a = tile.axis, &c = node.centre_m, &h = node.half_m, &normal = node.axis;
  if (request.leave_out_hidden && a != glm::vec3(0.0f) &&
      node_terms::cut_is_behind(a.x, a.y, a.z, tile.slack_m, tile.lowest_m, c.x, c.y, c.z, h.x, h.y,
                                h.z)) {
    return kHiddenStep;
  }
  const glm::vec3 to = tile.centre_m - c;
  const float distance_m = node_terms::cut_distance_m(to.x, to.y, to.z);
  if (request.leave_out_hidden &&
      node_terms::cut_faces_away(normal.x, normal.y, normal.z, node.cos_spread, h.x, h.y, h.z,
                                 tile.radius_m, tile.slack_m, node.radius_m + tile.radius_m, to.x,
                                 to.y, to.z, distance_m)) {
    return kHiddenStep;
  }
  if (node.child == 0) return -1;
  const float bound = node_terms::node_bound_per_m2(request.smallest_bound_per_m2, node.per_m2);
  return node_terms::cut_step(node_terms::cut_error(node.flux_lm, node.radius_m, node.cos_spread,
                                                    bound, distance_m, tile.softening_m,
                                                    tile.radius_m));
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

void Cut::build(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request) {
  open_nodes(tree, tile, request);
  resize(taken_);
  collect(tree, request.smallest_bound_per_m2);
}

// In rounds: all nodes from a step of error on at once, or as many as there is room for, by their
// place in the pool. What is taken then depends on no other order, so that a device that opens many
// nodes at a time takes the same (gpu/shaders/gather/choose.glsl).
void Cut::open_nodes(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request) {
  const std::span<const VertexNode> nodes = tree.nodes();
  state_.resize(std::max(state_.size(), nodes.size()), kUnseen);
  std::size_t count = 0;
  int highest = -1, lowest = std::numeric_limits<int>::max();
  const auto queue_at = [&](int step) -> std::vector<std::uint32_t>& {
    if (queue_.size() <= static_cast<std::size_t>(step))
      queue_.resize(static_cast<std::size_t>(step) + 1);
    return queue_[static_cast<std::size_t>(step)];
  };
  const auto add = [&](std::uint32_t n) {
    touched_.push_back(n);
    const int step = step_of(tree, tile, request, n);
    state_[n] = step == kHiddenStep ? kHidden : kTaken;
    if (step == kHiddenStep) return;
    ++count;
    if (step < 0) return;
    highest = std::max(highest, step);
    queue_at(step).push_back(n);
  };
  for (const std::uint32_t root : tree.roots()) add(root);
  while (count < request.nodes) {
    while (highest >= 0 && queue_at(highest).empty()) --highest;
    if (highest < 0) break;
    // A part may have a larger error than the whole: then it is opened in the round after.
    lowest = std::min(lowest, highest);
    round_.clear();
    for (; highest >= lowest; --highest) {
      auto& queue = queue_at(highest);
      round_.insert(round_.end(), queue.begin(), queue.end());
      queue.clear();
    }
    const std::size_t room = request.nodes - count;
    if (round_.size() > room) {
      std::sort(round_.begin(), round_.end(),
                [&](std::uint32_t a, std::uint32_t b) { return nodes[a].first < nodes[b].first; });
      highest = lowest;  // the rest waits
      auto& queue = queue_at(lowest);
      queue.assign(round_.begin() + static_cast<std::ptrdiff_t>(room), round_.end());
      round_.resize(room);
    }
    for (const std::uint32_t n : round_) {
      state_[n] = kOpened;
      --count;
      add(nodes[n].child);
      add(nodes[n].child + 1);
    }
  }
  for (auto& queue : queue_) queue.clear();
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
  open_nodes(tree, tile, request);
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
    bound_per_m2_[c] = node_terms::node_bound_per_m2(smallest_bound_per_m2, node.per_m2);
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
