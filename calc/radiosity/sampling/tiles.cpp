#include "calc/radiosity/sampling/tiles.h"

#include "calc/radiosity/sampling/identity.h"
#include "calc/radiosity/sampling/radix_sort.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace calc {

ReceiverTiles::ReceiverTiles(std::vector<ReceiverGroup> groups)
    : groups_(std::move(groups)), identity_(new_identity()) {
  for (const ReceiverGroup& group : groups_) {
    before_.push_back(before_.back() + group.receiver.size());
    for (const Receiver& receiver : group.receiver) {
      kernels_ |= 1u << static_cast<std::uint32_t>(receiver.kernel);
    }
  }
}

std::size_t ReceiverTiles::group_of(std::size_t receiver) const {
  const auto behind = std::upper_bound(before_.begin(), before_.end(), receiver);
  return static_cast<std::size_t>(behind - before_.begin()) - 1;
}

std::vector<std::uint32_t> spatial_order(const std::vector<Receiver>& receiver) {
  if (receiver.empty()) return {};
  glm::dvec3 low = receiver.front().position_m;
  glm::dvec3 high = low;
  for (const Receiver& r : receiver) {
    low = glm::min(low, r.position_m);
    high = glm::max(high, r.position_m);
  }
  const glm::dvec3 size = high - low;
  constexpr int kBits = 16;
  const double scale = ((1 << kBits) - 1) / std::max({size.x, size.y, size.z, 1e-9});
  std::vector<KeyedIndex> keys;
  for (std::size_t i = 0; i < receiver.size(); ++i) {
    const glm::dvec3 cell = (receiver[i].position_m - low) * scale;
    std::uint64_t key = 0;
    for (int bit = kBits - 1; bit >= 0; --bit) {
      for (int axis = 0; axis < 3; ++axis) {
        key = (key << 1) | ((static_cast<std::uint64_t>(cell[axis]) >> bit) & 1u);
      }
    }
    keys.push_back({key, static_cast<std::uint32_t>(i)});
  }
  radix_sort(keys, 3 * kBits);
  std::vector<std::uint32_t> order;
  for (const KeyedIndex& k : keys) order.push_back(k.index);
  return order;
}

ReceiverTiles make_tiles(const std::vector<Receiver>& receiver,
                         const std::vector<std::uint32_t>& order,
                         const std::vector<std::uint8_t>& is_wanted) {
  constexpr std::size_t kTilePoints = 32;
  std::vector<ReceiverGroup> tiles;
  for (const std::uint32_t i : order) {
    if (is_wanted[i] == 0) continue;
    if (tiles.empty() || tiles.back().point.size() == kTilePoints) tiles.emplace_back();
    tiles.back().point.push_back(i);
    tiles.back().receiver.push_back(receiver[i]);
  }
  return ReceiverTiles(std::move(tiles));
}

}  // namespace calc
