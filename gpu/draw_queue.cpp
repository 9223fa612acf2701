#include "gpu/draw_queue.h"

#include "calc/radiosity/gatherer.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gpu {
namespace {

constexpr double kGlance_s = 0.0005;   // between looks for pieces of others
constexpr std::size_t kMostWaves = 3;  // under way, with the last
constexpr std::size_t kMostPieces = DrawPass::kSlots / kMostWaves;  // of a wave
constexpr std::size_t kEnoughWaves = 2;  // whose rays were sent: one is worked on, one waits

template <class Entries>
std::vector<DrawTask> tasks_of(const Entries& entries) {
  std::vector<DrawTask> tasks;
  for (const auto* entry : entries) tasks.push_back(entry->task);
  return tasks;
}

}  // namespace

void DrawQueue::run(DeviceThread& thread, DrawPiece& piece, const PackedPool* pool,
                    const DrawPoints::Packed* points) {
  Entry entry{{&piece, pool, points}, false, ""};
  {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(&entry);
  }
  try {
    thread.run([&](DeviceState& device) {
      while (!entry.is_done) advance(device);
    });
  } catch (const calc::BackendFailure&) {
    const std::scoped_lock lock(mutex_);
    std::erase(waiting_, &entry);
    throw;
  }
  if (!entry.problem.empty()) throw calc::BackendFailure(entry.problem);
}

std::size_t DrawQueue::waiting() const {
  const std::scoped_lock lock(mutex_);
  return waiting_.size();
}

// The first that waits, and those behind it that fit in with it.
DrawQueue::Wave DrawQueue::next_wave() {
  Wave wave;
  std::size_t places = 0, weights = 0;
  const std::scoped_lock lock(mutex_);
  while (!waiting_.empty() && wave.size() < kMostPieces) {
    Entry* entry = waiting_.front();
    places += entry->task.piece->places();
    weights += entry->task.piece->weights();
    if (!wave.empty() && (places > limits_.places || weights > limits_.weights)) break;
    const std::optional<std::size_t> slot = pass_->take_slot(*entry->task.piece);
    if (!slot) break;
    entry->task.slot = *slot;
    wave.push_back(entry);
    waiting_.pop_front();
  }
  return wave;
}

bool DrawQueue::has_room() const {
  return under_way_.size() + (drawn_.empty() ? 0 : 1) < kMostWaves;
}

// The wave's choices, if there is one, and the rays of the wave before.
void DrawQueue::send(DeviceState& device, Wave wave) {
  if (!wave.empty()) {
    ++sent_.waves;
    sent_.most_pieces = std::max(sent_.most_pieces, wave.size());
    if (!drawn_.empty()) ++sent_.beside;
  }
  std::swap(drawn_, wave);
  if (!wave.empty()) under_way_.push_back(wave);
  pass_->send(device, tasks_of(drawn_), tasks_of(wave));
  places_per_dispatch_ = pass_->places_per_dispatch();
}

void DrawQueue::finish_oldest(DeviceState& device) {
  Wave& wave = under_way_.front();
  Entry* oldest = wave.front();
  pass_->finish(device, oldest->task);
  oldest->is_done = true;
  wave.erase(wave.begin());
  if (wave.empty()) under_way_.pop_front();
}

void DrawQueue::advance(DeviceState& device) {
  try {
    if (!pass_) pass_ = std::make_unique<DrawPass>(device.context.device(), limits_);
    while (has_room()) {
      Wave wave = next_wave();
      if (wave.empty()) break;
      send(device, std::move(wave));
    }
    if (!drawn_.empty() && under_way_.size() < kEnoughWaves) send(device, {});
    // Meanwhile others may send theirs.
    if (has_room() && !pass_->is_ready(under_way_.front().front()->task, kGlance_s)) return;
    finish_oldest(device);
  } catch (const std::exception& error) {
    fail_all(error.what());
    device.clear();  // what is kept for later may be what leaves no room
    pass_.reset();
    throw;
  }
}

// All that is under way; what waits may yet do better.
void DrawQueue::fail_all(const std::string& problem) {
  under_way_.push_back(std::exchange(drawn_, {}));
  for (const Wave& wave : under_way_) {
    for (Entry* entry : wave) {
      entry->problem = problem;
      entry->is_done = true;
    }
  }
  under_way_.clear();
}

}  // namespace gpu
