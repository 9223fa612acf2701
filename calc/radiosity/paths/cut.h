#pragma once
// Selects groups of light vertices for a tile of receivers, and their probabilities.

#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/receiver.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

// A sphere around receivers; axis: their common axis if all are planar and face alike, else 0.
struct ReceiverTile {
  glm::vec3 centre_m{0.0f};
  float radius_m = 0.0f;
  glm::vec3 axis{0.0f};
  float softening_m = 0.0f;  // distances below it count as it, so that a cut serves a whole region
  float slack_m = 0.0f;      // what rounding may add to a distance
  float lowest_m = 0.0f;     // of dot(axis, position) over the receivers
};

// Returns the tile of these receivers. extent_m: of the whole scene.
ReceiverTile tile_of(std::span<const Receiver> receivers, double extent_m);

struct CutRequest {
  std::size_t nodes = 0;               // about
  float smallest_bound_per_m2 = 0.0f;  // GeometryBound::smallest(); only shapes probabilities
  // Omits nodes that are wholly behind the receivers' common plane or face away, exactly 0.
  bool leave_out_hidden = true;
};

// Nodes that together hold every vertex that can light the tile, as arrays in pool order.
class Cut {
 public:
  // The nodes of one channel: begin..end of the cut.
  struct ChannelRange {
    std::uint32_t begin, end;
  };

  // Opens the nodes with the largest expected error until there are request.nodes, or no more can
  // be opened; at least one for each channel.  [METHOD, 5.2; light cuts: Walter05]
  void build(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request);

  // Appends the same nodes as indices in the tree, for callers with their own weights, and the
  // ranges of this cut, which count from its first node. The result of build() stays.
  void select(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request,
              std::vector<std::uint32_t>& nodes, std::vector<ChannelRange>& channels);

  // Sets probability[c] of node c up to a common factor, > 0: its expected bounded contribution to
  // the receiver.
  void weigh(const Receiver& receiver, std::vector<float>& probability) const;

  std::size_t size() const { return first_.size(); }
  std::uint32_t first(std::size_t c) const { return first_[c]; }
  std::uint32_t count(std::size_t c) const { return count_[c]; }
  float flux_lm(std::size_t c) const { return flux_lm_[c]; }
  std::span<const std::uint32_t> nodes() const { return node_; }  // indices in the tree
  std::span<const ChannelRange> channels() const { return channel_; }

 private:
  void open_nodes(const VertexTree& tree, const ReceiverTile& tile, const CutRequest& request);
  template <class Take>
  void visit_taken(const VertexTree& tree, std::vector<ChannelRange>& channels, const Take& take);
  void resize(std::size_t size);
  void collect(const VertexTree& tree, float smallest_bound_per_m2);

  // [step of error] nodes that could be opened: a queue without a search.
  std::vector<std::vector<std::uint32_t>> queue_;
  std::vector<std::uint8_t> state_;  // [node] of the tree
  std::vector<std::uint32_t> round_, touched_, stack_;
  std::size_t taken_ = 0;

  std::vector<std::uint32_t> node_, first_, count_;
  std::vector<ChannelRange> channel_;
  std::vector<float> flux_lm_, radius_m_, bound_per_m2_, centre_x_, centre_y_, centre_z_;
  std::vector<float> x_, y_, z_, nx_, ny_, nz_;
};

}  // namespace calc
