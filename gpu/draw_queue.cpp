#include "gpu/draw_queue.h"

#include "calc/radiosity/gatherer.h"

#include <exception>

namespace gpu {
namespace {

constexpr double kGlance_s = 0.0005;  // between looks for pieces of others

}  // namespace

void DrawQueue::run(DeviceThread& thread, DevicePools& pools, DrawPiece& piece,
                    const PackedPool* packed) {
  Entry entry{&piece, packed, false, ""};
  {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(&entry);
  }
  try {
    thread.run([&](DeviceState& device) {
      while (!entry.is_done) advance(device, pools);
    });
  } catch (const calc::BackendFailure&) {
    const std::scoped_lock lock(mutex_);
    std::erase(waiting_, &entry);
    throw;
  }
  if (!entry.problem.empty()) throw calc::BackendFailure(entry.problem);
}

DrawQueue::Entry* DrawQueue::next_waiting() {
  const std::scoped_lock lock(mutex_);
  if (waiting_.empty()) return nullptr;
  Entry* entry = waiting_.front();
  waiting_.pop_front();
  return entry;
}

void DrawQueue::advance(DeviceState& device, DevicePools& pools) {
  try {
    if (!pass_) pass_ = std::make_unique<DrawPass>(device.context.device(), most_places_);
    while (under_way_.size() < DrawPass::kSlots) {
      Entry* entry = next_waiting();
      if (entry == nullptr) break;
      under_way_.push_back(entry);
      pass_->start(device, pools, next_slot_, *entry->piece, entry->packed);
      next_slot_ = (next_slot_ + 1) % DrawPass::kSlots;
      places_per_dispatch_ = pass_->places_per_dispatch();
    }
    const std::size_t oldest =
        (next_slot_ + DrawPass::kSlots - under_way_.size()) % DrawPass::kSlots;
    // Meanwhile others may send theirs.
    if (under_way_.size() < DrawPass::kSlots && !pass_->is_ready(oldest, kGlance_s)) return;
    pass_->finish(device, oldest, *under_way_.front()->piece);
    under_way_.front()->is_done = true;
    under_way_.pop_front();
  } catch (const std::exception& error) {
    fail_all(error.what());
    pools.clear();  // what is kept for later may be what leaves no room
    pass_.reset();
    throw;
  }
}

// All that is under way; what waits may yet do better.
void DrawQueue::fail_all(const std::string& problem) {
  for (Entry* entry : under_way_) {
    entry->problem = problem;
    entry->is_done = true;
  }
  under_way_.clear();
  next_slot_ = 0;
}

}  // namespace gpu
