#include "gpu/device_points.h"

#include "calc/radiosity/cut.h"
#include "gpu/gl_error.h"

#include <algorithm>

namespace gpu {
namespace {

constexpr std::size_t kMostBlocks = 4096;  // of planes of a few points each
constexpr std::size_t kMostBytes = std::size_t{1} << 28;

DrawTileView view_of(const calc::ReceiverTile& tile) {
  const float has_axis = tile.axis != glm::vec3(0.0f) ? 1.0f : 0.0f;
  return {tile.centre_m, tile.radius_m, tile.axis, tile.softening_m,
          tile.slack_m,  tile.lowest_m, has_axis};
}

}  // namespace

PackedPoints pack_points(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                         std::size_t block) {
  PackedPoints packed;
  const std::size_t first = block * kTilesPerBlock;
  const std::size_t last = std::min(first + kTilesPerBlock, tiles.groups().size());
  packed.receivers.reserve(tiles.receivers_before(last) - tiles.receivers_before(first));
  for (std::size_t t = first; t < last; ++t) {
    const calc::ReceiverGroup& group = tiles.groups()[t];
    packed.views.push_back(view_of(calc::tile_of(group.receiver, tracer.scene().extent_m)));
    for (std::size_t k = 0; k < group.receiver.size(); ++k) {
      const calc::Receiver& receiver = group.receiver[k];
      DrawReceiver& sent = packed.receivers.emplace_back();
      sent.position_m = glm::vec3(receiver.position_m);
      sent.axis = glm::vec3(receiver.axis);
      sent.lifted_m = glm::vec3(tracer.lift(receiver));
      sent.tile = static_cast<std::uint32_t>(t - first);
      sent.kernel = static_cast<std::uint32_t>(receiver.kernel);
      sent.random = {group.point[k], 0u};
    }
  }
  return packed;
}

std::shared_ptr<const PackedPoints> DevicePoints::pack_unless_held(const calc::Tracer& tracer,
                                                                   const calc::ReceiverTiles& tiles,
                                                                   std::size_t block) {
  const Key key{tracer.identity(), tiles.identity(), block};
  {
    const std::scoped_lock lock(mutex_);
    if (known_.contains(key)) return nullptr;
  }
  return packings_.get(key, [&] { return pack_points(tracer, tiles, block); });
}

const DeviceBlock& DevicePoints::find_or_send(const calc::Tracer& tracer,
                                              const calc::ReceiverTiles& tiles, std::size_t block,
                                              const PackedPoints* packed) {
  const Key key{tracer.identity(), tiles.identity(), block};
  if (const auto found = known_.find(key); found != known_.end()) {
    held_.splice(held_.begin(), held_, found->second);
    return held_.front().block;
  }
  Held sent{key, {}};
  const PackedPoints own = packed != nullptr ? PackedPoints() : pack_points(tracer, tiles, block);
  if (packed == nullptr) packed = &own;
  sent.block.receivers.assign(packed->receivers);
  sent.block.views.assign(packed->views);
  check_gl("sending calculation points");
  const std::scoped_lock lock(mutex_);
  bytes_ += sent.bytes();
  while (!held_.empty() && (held_.size() >= kMostBlocks || bytes_ > kMostBytes)) {
    bytes_ -= held_.back().bytes();
    known_.erase(held_.back().key);
    held_.pop_back();
  }
  held_.push_front(std::move(sent));
  known_[key] = held_.begin();
  return held_.front().block;
}

void DevicePoints::clear() {
  const std::scoped_lock lock(mutex_);
  known_.clear();
  held_.clear();
  bytes_ = 0;
}

}  // namespace gpu
