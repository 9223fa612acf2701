#pragma once
// Queues pieces of drawn connections of many threads for one device.

#include "gpu/gather/draw_pass.h"

#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <vector>

namespace gpu {

// Waiting pieces go together, as far as they need no more room than a large piece, because only a
// batch of small rooms' pieces fills a device. Once sent, pieces wait with their draws known until
// the next are sent, so that their rays run beside the choices of those; but not while the device
// would run out of work.
class DrawQueue {
 public:
  explicit DrawQueue(const DrawLimits& limits) : limits_(limits) {}

  // Waits for the piece. pool, points: as in DrawTask. Throws calc::BackendFailure.
  void run(DeviceThread& thread, DrawPiece& piece, const PackedPool* pool,
           const DrawPoints::Packed* points);
  // Clears the pass; needs the context current and nothing under way.
  void clear() { pass_.reset(); }
  // Returns DrawPass::places_per_dispatch(), 0 before the first piece. For all threads.
  std::size_t places_per_dispatch() const { return places_per_dispatch_; }

  // For tests: the number of waiting pieces, and the record of sent ones.
  struct Sent {
    std::size_t batches = 0, most_pieces = 0;  // pieces that went together
    std::size_t beside = 0;                    // batches whose choices went beside rays of others
  };
  std::size_t waiting() const;
  Sent sent() const { return sent_; }

 private:
  struct Entry {
    DrawTask task;
    bool is_done = false;
    std::exception_ptr failure;  // null: none
  };
  using Batch = std::vector<Entry*>;

  // Sends waiting pieces as long as there is room, then finishes the oldest, unless others might be
  // sent meanwhile. On the context's thread.
  void advance(DeviceState& device);
  void take_batch();
  void send(DeviceState& device);
  bool has_room() const;
  void finish_oldest(DeviceState& device);
  void fail_all(const std::exception_ptr& failure);

  const DrawLimits limits_;
  std::atomic<std::size_t> places_per_dispatch_{0};
  mutable std::mutex mutex_;
  std::deque<Entry*> waiting_;
  // Only for the context's thread.
  std::unique_ptr<DrawPass> pass_;
  Batch next_;                   // not sent yet
  Batch drawn_;                  // the last batch, if its rays were not sent
  std::deque<Batch> under_way_;  // those before, oldest first; none is empty
  Sent sent_;
};

}  // namespace gpu
