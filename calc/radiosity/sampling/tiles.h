#pragma once
// Points of a plane in groups of neighbours, which share one cut.

#include "calc/radiosity/sampling/receiver.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

struct ReceiverGroup {
  std::vector<std::uint32_t> point;  // index in the plane
  std::vector<Receiver> receiver;    // the same order
};

// Groups that stay as they are as long as they live, so that a device may keep what it made of
// them.
class ReceiverTiles {
 public:
  ReceiverTiles() = default;                                  // none
  explicit ReceiverTiles(std::vector<ReceiverGroup> groups);  // none of them empty

  std::span<const ReceiverGroup> groups() const { return groups_; }
  // The group of a receiver, counted in their order. receiver < receivers().
  std::size_t group_of(std::size_t receiver) const;
  // Receivers in the groups before this one; groups().size() is allowed.
  std::size_t receivers_before(std::size_t group) const { return before_[group]; }
  std::size_t receivers() const { return before_.back(); }
  // Of any receiver: 1 << ReceiverKernel.
  std::uint32_t kernels() const { return kernels_; }
  // Never that of other groups in this process; 0 = none.
  std::uint64_t identity() const { return identity_; }

 private:
  std::vector<ReceiverGroup> groups_;
  std::vector<std::size_t> before_{0};
  std::uint32_t kernels_ = 0;
  std::uint64_t identity_ = 0;
};

// Points along a Morton curve in the two or three directions of their extent: neighbours together.
std::vector<std::uint32_t> spatial_order(const std::vector<Receiver>& receiver);

// The wanted points ([point], 1 = yes), up to 32 in a group, in the given order.
ReceiverTiles make_tiles(const std::vector<Receiver>& receiver,
                         const std::vector<std::uint32_t>& order,
                         const std::vector<std::uint8_t>& is_wanted);

}  // namespace calc
