#pragma once
// Calculation points on the device: those of a plane in one look, sent once for all its replicates.

#include "calc/radiosity/rays.h"
#include "calc/radiosity/tiles.h"
#include "gpu/gl_buffer.h"
#include "gpu/pack_once.h"

#include <glm/glm.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace gpu {

// A receiver as the shaders of draws read it: four uvec4, the first three with vectors of floats.
struct DrawReceiver {
  glm::vec3 position_m;  // local
  std::uint32_t unused0 = 0;
  glm::vec3 axis;
  std::uint32_t unused1 = 0;
  glm::vec3 lifted_m;  // where its rays begin
  std::uint32_t unused2 = 0;
  std::uint32_t tile;    // of its block
  std::uint32_t kernel;  // calc::ReceiverKernel
  // A point's index in its plane, and 0; of a hit of a short ray the halves of its shift.
  glm::uvec2 random;
};
static_assert(sizeof(DrawReceiver) == 64);

// A tile as shaders/choose.glsl reads it: three vec4, calc::ReceiverTile.
struct DrawTileView {
  glm::vec3 centre_m;
  float radius_m;
  glm::vec3 axis;
  float softening_m;
  float slack_m, lowest_m;
  float has_axis;  // 1 = yes
  float unused = 0.0f;
};
static_assert(sizeof(DrawTileView) == 48);

// Tiles that are kept together, 8 MiB of receivers: buffers may be no larger than 128 MiB.
inline constexpr std::size_t kTilesPerBlock = 4096;

struct PackedPoints {
  std::vector<DrawReceiver> receivers;
  std::vector<DrawTileView> views;
};

// Tiles block * kTilesPerBlock and on.
PackedPoints pack_points(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                         std::size_t block);

struct DeviceBlock {
  GlBuffer receivers{"calculation points", BufferUse::fixed};
  GlBuffer views{"tiles of calculation points", BufferUse::fixed};
};

// The blocks used last.
class DevicePoints {
 public:
  // For all threads: what find_or_send() takes; null if the device has it.
  std::shared_ptr<const PackedPoints> pack_unless_held(const calc::Tracer& tracer,
                                                       const calc::ReceiverTiles& tiles,
                                                       std::size_t block);

  // All others need the context current in which the blocks live, the destructor too.
  // packed: of pack_unless_held(); null, though it is not there any more: packed now. Valid until
  // the next call. Throws GlError.
  const DeviceBlock& find_or_send(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                                  std::size_t block, const PackedPoints* packed);
  void clear();

 private:
  struct Key {
    std::uint64_t tracer, tiles;  // their identities
    std::size_t block;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  struct Held {
    Key key;
    DeviceBlock block;

    std::size_t bytes() const { return block.receivers.bytes() + block.views.bytes(); }
  };

  std::mutex mutex_;      // changes of the list, and reading it outside the context's thread
  std::list<Held> held_;  // latest use first
  std::map<Key, std::list<Held>::iterator> known_;
  std::size_t bytes_ = 0;
  PackOnce<Key, PackedPoints> packings_;
};

}  // namespace gpu
