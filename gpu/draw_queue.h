#pragma once
// Pieces of drawn connections of many threads, on their way to one device.

#include "gpu/draw_pass.h"

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

namespace gpu {

class DrawQueue {
 public:
  // Waits for the piece. packed: as in DrawPass::start(). Throws calc::BackendFailure.
  void run(DeviceThread& thread, DevicePools& pools, DrawPiece& piece, const PackedPool* packed);
  // With the context current. Nothing may be under way.
  void clear() { pass_.reset(); }

 private:
  struct Entry {
    DrawPiece* piece;
    const PackedPool* packed;
    bool is_done = false;
    std::string problem;
  };

  // On the context's thread: sends what waits as long as there is room, then finishes the oldest.
  void advance(DeviceState& device, DevicePools& pools);
  Entry* next_waiting();
  void fail_all(const std::string& problem);

  std::mutex mutex_;
  std::deque<Entry*> waiting_;
  // Of the context's thread alone.
  std::unique_ptr<DrawPass> pass_;
  std::deque<Entry*> under_way_;
  std::size_t next_slot_ = 0;
};

}  // namespace gpu
