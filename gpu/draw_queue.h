#pragma once
// Pieces of drawn connections of many threads, on their way to one device.

#include "gpu/draw_pass.h"

#include <atomic>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

namespace gpu {

class DrawQueue {
 public:
  // most_places: DrawLimits::dispatch.
  explicit DrawQueue(std::size_t most_places) : most_places_(most_places) {}

  // Waits for the piece. packed: as in DrawPass::start(). Throws calc::BackendFailure.
  void run(DeviceThread& thread, DevicePools& pools, DrawPiece& piece, const PackedPool* packed);
  // With the context current. Nothing may be under way.
  void clear() { pass_.reset(); }
  // As DrawPass::places_per_dispatch(), 0 before the first piece. For all threads.
  std::size_t places_per_dispatch() const { return places_per_dispatch_; }

 private:
  struct Entry {
    DrawPiece* piece;
    const PackedPool* packed;
    bool is_done = false;
    std::string problem;
  };

  // On the context's thread: sends what waits as long as there is room, then finishes the oldest,
  // unless others might yet be sent meanwhile.
  void advance(DeviceState& device, DevicePools& pools);
  Entry* next_waiting();
  void fail_all(const std::string& problem);

  const std::size_t most_places_;
  std::atomic<std::size_t> places_per_dispatch_{0};
  std::mutex mutex_;
  std::deque<Entry*> waiting_;
  // Of the context's thread alone.
  std::unique_ptr<DrawPass> pass_;
  std::deque<Entry*> under_way_;
  std::size_t next_slot_ = 0;
};

}  // namespace gpu
