#include "gpu/dispatch_pacer.h"

#include "calc/radiosity/phase_timer.h"

#include <algorithm>

namespace gpu {

// Dispatches that were sent before the last change count as well: twice as many, or half, is then
// what there is already.
void DispatchSize::learn(std::size_t items, double seconds) {
  if (seconds < kShort_s) {
    items_ = std::max(items_, 2 * items);
  } else if (seconds > kLong_s) {
    // At once where it took far too long: a watchdog may not wait for halves.
    const double share = std::clamp(kShort_s / seconds, 0.125, 0.5);
    items_ = std::min(items_, static_cast<std::size_t>(share * static_cast<double>(items)));
  }
  items_ = std::clamp(items_, fewest_, most_);
}

void DispatchPacer::begin(const std::string& doing) {
  while (!under_way_.empty() &&
         (under_way_.size() >= kMostUnderWay || under_way_.front().fence.is_reached())) {
    under_way_.front().fence.wait(doing);
    take_oldest();
  }
  begun_s_ = calc::now_s();
}

void DispatchPacer::end(std::size_t items) {
  under_way_.push_back({GlFence::set(), begun_s_, items});
  // Software may have done it by now, and its time must not include the next one's.
  while (!under_way_.empty() && under_way_.front().fence.is_reached()) take_oldest();
}

// It began when it was sent, or when the one before was done.
void DispatchPacer::take_oldest() {
  const UnderWay& oldest = under_way_.front();
  const double now_s = calc::now_s();
  size_.learn(oldest.items, now_s - std::max(oldest.begun_s, reached_s_));
  reached_s_ = now_s;
  under_way_.pop_front();
}

}  // namespace gpu
