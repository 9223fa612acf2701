#pragma once
// Divides the points of a plane into groups of neighbours, which share one cut.

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

// Groups that never change, so that a device may keep data made from them.
class ReceiverTiles {
 public:
  ReceiverTiles() = default;                                  // none
  explicit ReceiverTiles(std::vector<ReceiverGroup> groups);  // none of them empty

  std::span<const ReceiverGroup> groups() const { return groups_; }
  // Returns the group of a receiver, counted in their order. Requires receiver < receivers().
  std::size_t group_of(std::size_t receiver) const;
  // Returns the receivers in the groups before this one; groups().size() is allowed.
  std::size_t receivers_before(std::size_t group) const { return before_[group]; }
  std::size_t receivers() const { return before_.back(); }
  // Returns the kernels of all receivers: bits 1 << ReceiverKernel.
  std::uint32_t kernels() const { return kernels_; }
  // Returns a number that no other groups in this process have; 0 = none.
  std::uint64_t identity() const { return identity_; }

 private:
  std::vector<ReceiverGroup> groups_;
  std::vector<std::size_t> before_{0};
  std::uint32_t kernels_ = 0;
  std::uint64_t identity_ = 0;
};

// Orders points along a Morton curve in the 2 or 3 directions of their extent.
std::vector<std::uint32_t> spatial_order(const std::vector<Receiver>& receiver);

// Returns the wanted points ([point], 1 = yes), up to 32 in a group, in the given order.
ReceiverTiles make_tiles(const std::vector<Receiver>& receiver,
                         const std::vector<std::uint32_t>& order,
                         const std::vector<std::uint8_t>& is_wanted);

}  // namespace calc
