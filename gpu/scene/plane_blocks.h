#pragma once
// Keeps a plane's points of one sampling round on the device, sent once for all its replicates,
// some tiles at a time.

#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/tiles.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/opengl/pack_once.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace gpu {

// Tiles kept together, some 10 MiB: buffers may be no larger than 128 MiB.
inline constexpr std::size_t kTilesPerBlock = 4096;

// The blocks used last. Kind: the kind of data, see device_points.h.
template <class Kind>
class PlaneBlocks {
 public:
  using Packed = typename Kind::Packed;
  using Block = typename Kind::Block;

  // Returns the data for find_or_send(); null if the device has it. For all threads.
  std::shared_ptr<const Packed> pack_unless_held(const calc::Tracer& tracer,
                                                 const calc::ReceiverTiles& tiles,
                                                 std::size_t block) {
    const Key key{tracer.identity(), tiles.identity(), block};
    {
      const std::scoped_lock lock(mutex_);
      if (known_.contains(key)) return nullptr;
    }
    return packings_.get(key, [&] { return Kind::pack(tracer, tiles, block); });
  }

  // All others, also the destructor, need the context current in which the blocks live. Returns a
  // block, valid until the next call. packed: of pack_unless_held(); null, but the block is gone:
  // packs it now. Throws GlError.
  const Block& find_or_send(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                            std::size_t block, const Packed* packed) {
    const Key key{tracer.identity(), tiles.identity(), block};
    // Only this thread changes it.
    if (const auto found = known_.find(key); found != known_.end()) {
      held_.splice(held_.begin(), held_, found->second);
      return held_.front().block;
    }
    Held sent{key, {}};
    if (packed != nullptr) {
      Kind::send(*packed, sent.block);
    } else {
      Kind::send(Kind::pack(tracer, tiles, block), sent.block);
    }
    check_gl("sending calculation points");
    const std::scoped_lock lock(mutex_);
    bytes_ += Kind::bytes(sent.block);
    while (!held_.empty() && (held_.size() >= kMostBlocks || bytes_ > kMostBytes)) {
      bytes_ -= Kind::bytes(held_.back().block);
      known_.erase(held_.back().key);
      held_.pop_back();
    }
    held_.push_front(std::move(sent));
    known_[key] = held_.begin();
    return held_.front().block;
  }

  void clear() {
    const std::scoped_lock lock(mutex_);
    known_.clear();
    held_.clear();
    bytes_ = 0;
  }

 private:
  static constexpr std::size_t kMostBlocks = 4096;  // of planes of a few points each
  static constexpr std::size_t kMostBytes = std::size_t{1} << 28;

  struct Key {
    std::uint64_t tracer, tiles;  // their identities
    std::size_t block;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  struct Held {
    Key key;
    Block block;
  };

  std::mutex mutex_;      // changes, and what other threads read
  std::list<Held> held_;  // latest use first
  std::map<Key, typename std::list<Held>::iterator> known_;
  std::size_t bytes_ = 0;
  PackOnce<Key, Packed> packings_;
};

}  // namespace gpu
