#include "gpu/scene/device_points.h"

#include "calc/radiosity/paths/cut.h"

#include <algorithm>

namespace gpu {
namespace {

DrawTileView view_of(const calc::ReceiverTile& tile) {
  const float has_axis = tile.axis != glm::vec3(0.0f) ? 1.0f : 0.0f;
  return {tile.centre_m, tile.radius_m, tile.axis, tile.softening_m,
          tile.slack_m,  tile.lowest_m, has_axis};
}

struct Tiles {
  std::size_t first, last, receivers;
};

Tiles tiles_of(const calc::ReceiverTiles& tiles, std::size_t block) {
  const std::size_t first = block * kTilesPerBlock;
  const std::size_t last = std::min(first + kTilesPerBlock, tiles.groups().size());
  return {first, last, tiles.receivers_before(last) - tiles.receivers_before(first)};
}

}  // namespace

DrawPoints::Packed DrawPoints::pack(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                                    std::size_t block) {
  Packed packed;
  const Tiles range = tiles_of(tiles, block);
  packed.receivers.reserve(range.receivers);
  for (std::size_t t = range.first; t < range.last; ++t) {
    const calc::ReceiverGroup& group = tiles.groups()[t];
    packed.views.push_back(view_of(calc::tile_of(group.receiver, tracer.scene().whole_extent_m())));
    for (std::size_t k = 0; k < group.receiver.size(); ++k) {
      const calc::Receiver& receiver = group.receiver[k];
      DrawReceiver& sent = packed.receivers.emplace_back();
      sent.position_m = glm::vec3(receiver.position_m);
      sent.axis = glm::vec3(receiver.axis);
      sent.lifted_m = glm::vec3(tracer.lift(receiver));
      sent.tile = static_cast<std::uint32_t>(t - range.first);
      sent.kernel = static_cast<std::uint32_t>(receiver.kernel);
      sent.random = {group.point[k], 0u};
    }
  }
  return packed;
}

void DrawPoints::send(const Packed& packed, Block& block) {
  block.receivers.assign(packed.receivers);
  block.views.assign(packed.views);
}

std::size_t DrawPoints::bytes(const Block& block) {
  return block.receivers.bytes() + block.views.bytes();
}

NearPoints::Packed NearPoints::pack(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                                    std::size_t block) {
  Packed packed;
  const Tiles range = tiles_of(tiles, block);
  packed.reserve(range.receivers);
  for (std::size_t t = range.first; t < range.last; ++t) {
    const calc::ReceiverGroup& group = tiles.groups()[t];
    for (std::size_t k = 0; k < group.receiver.size(); ++k) {
      const calc::Receiver& receiver = group.receiver[k];
      packed.push_back({receiver.position_m, receiver.axis, glm::vec3(tracer.lift(receiver)),
                        static_cast<std::uint32_t>(receiver.kernel), group.point[k]});
    }
  }
  return packed;
}

void NearPoints::send(const Packed& packed, Block& block) { block.receivers.assign(packed); }

std::size_t NearPoints::bytes(const Block& block) { return block.receivers.bytes(); }

}  // namespace gpu
