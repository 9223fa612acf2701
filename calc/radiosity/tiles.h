#pragma once
// Points of a plane in groups of neighbours, which share one cut.

#include "calc/radiosity/receiver.h"

#include <cstdint>
#include <vector>

namespace calc {

struct ReceiverGroup {
  std::vector<std::uint32_t> point;  // index in the plane
  std::vector<Receiver> receiver;    // the same order
};

// Points along a Morton curve in the two or three directions of their extent: neighbours together.
std::vector<std::uint32_t> spatial_order(const std::vector<Receiver>& receiver);

// The wanted points ([point], 1 = yes), up to 32 in a group, in the given order.
std::vector<ReceiverGroup> make_tiles(const std::vector<Receiver>& receiver,
                                      const std::vector<std::uint32_t>& order,
                                      const std::vector<std::uint8_t>& is_wanted);

}  // namespace calc
