#include "gpu/gather/draw_queue.h"

#include "calc/radiosity/gather/gatherer.h"

#include <algorithm>
#include <new>
#include <utility>

namespace gpu {
namespace {

constexpr double kGlance_s = 0.0005;     // between looks for pieces of others
constexpr std::size_t kMostBatches = 3;  // under way, with the last
constexpr std::size_t kMostPieces = DrawPass::kSlots / kMostBatches;  // of a batch
constexpr std::size_t kEnoughBatches = 2;  // whose rays were sent: one is worked on, one waits

template <class Entries>
std::vector<DrawTask> tasks_of(const Entries& entries) {
  std::vector<DrawTask> tasks;
  for (const auto* entry : entries) tasks.push_back(entry->task);
  return tasks;
}

[[noreturn]] void throw_backend_failure(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::bad_alloc&) {
    throw calc::BackendFailure("the program is out of memory");
  } catch (const std::exception& error) {
    throw calc::BackendFailure(error.what());
  }
}

}  // namespace

void DrawQueue::run(DeviceThread& thread, DrawPiece& piece, const PackedPool* pool,
                    const DrawPoints::Packed* points) {
  Entry entry{{&piece, pool, points}, false, nullptr};
  {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(&entry);
  }
  try {
    thread.run([&](DeviceState& device) {
      while (!entry.is_done) advance(device);
    });
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    std::erase(waiting_, &entry);
    throw;
  }
  if (entry.failure) throw_backend_failure(entry.failure);
}

std::size_t DrawQueue::waiting() const {
  const std::scoped_lock lock(mutex_);
  return waiting_.size();
}

// Takes the first that waits, and those behind it that fit in with it.
void DrawQueue::take_batch() {
  std::size_t places = 0, weights = 0;
  const std::scoped_lock lock(mutex_);
  while (!waiting_.empty() && next_.size() < kMostPieces) {
    Entry* entry = waiting_.front();
    places += entry->task.piece->places();
    weights += entry->task.piece->weights();
    if (!next_.empty() && (places > limits_.places || weights > limits_.weights)) break;
    const std::optional<std::size_t> slot = pass_->take_slot(*entry->task.piece);
    if (!slot) break;
    entry->task.slot = *slot;
    next_.push_back(entry);
    waiting_.pop_front();
  }
}

bool DrawQueue::has_room() const {
  return under_way_.size() + (drawn_.empty() ? 0 : 1) < kMostBatches;
}

// The next batch's choices, if there is one, and the rays of the batch before. At any time each
// entry is in one of the lists, so that fail_all() finds it.
void DrawQueue::send(DeviceState& device) {
  if (!next_.empty()) {
    ++sent_.batches;
    sent_.most_pieces = std::max(sent_.most_pieces, next_.size());
    if (!drawn_.empty()) ++sent_.beside;
  }
  pass_->send(device, tasks_of(next_), tasks_of(drawn_));
  places_per_dispatch_ = pass_->places_per_dispatch();
  if (!drawn_.empty()) under_way_.push_back(drawn_);
  drawn_.clear();
  std::swap(drawn_, next_);
}

void DrawQueue::finish_oldest(DeviceState& device) {
  Batch& batch = under_way_.front();
  Entry* oldest = batch.front();
  pass_->finish(device, oldest->task);
  oldest->is_done = true;
  batch.erase(batch.begin());
  if (batch.empty()) under_way_.pop_front();
}

void DrawQueue::advance(DeviceState& device) {
  try {
    if (!pass_) pass_ = std::make_unique<DrawPass>(device.context.device(), limits_);
    while (has_room()) {
      take_batch();
      if (next_.empty()) break;
      send(device);
    }
    if (!drawn_.empty() && under_way_.size() < kEnoughBatches) send(device);
    // Meanwhile others may send theirs.
    if (has_room() && !pass_->is_ready(under_way_.front().front()->task, kGlance_s)) return;
    finish_oldest(device);
  } catch (...) {
    fail_all(std::current_exception());
    device.clear();  // what is kept for later may be what leaves no room
    pass_.reset();
    throw;
  }
}

// All that is under way; what waits may yet do better. Needs no memory: that may be what failed.
void DrawQueue::fail_all(const std::exception_ptr& failure) {
  const auto fail = [&](Batch& batch) {
    for (Entry* entry : batch) {
      entry->failure = failure;
      entry->is_done = true;
    }
    batch.clear();
  };
  fail(next_);
  fail(drawn_);
  for (Batch& batch : under_way_) fail(batch);
  under_way_.clear();
}

}  // namespace gpu
