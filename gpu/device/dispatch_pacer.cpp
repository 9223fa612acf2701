#include "gpu/device/dispatch_pacer.h"

#include "calc/radiosity/sampling/phase_timer.h"

#include <algorithm>
#include <utility>

namespace gpu {

// Dispatches that were sent before the last change count as well: twice as many, or half, is then
// what there is already.
void DispatchSize::learn(std::size_t items, double least_s, double most_s) {
  if (most_s < kShort_s) {
    items_ = std::max(items_, 2 * items);
  } else if (least_s > kLong_s) {
    // At once where it took far too long: a watchdog may not wait for halves.
    const double share = std::clamp(kShort_s / least_s, 0.125, 0.5);
    items_ = std::min(items_, static_cast<std::size_t>(share * static_cast<double>(items)));
  }
  items_ = std::clamp(items_, fewest_, most_);
}

DispatchPacer::Mark DispatchPacer::Mark::set() {
  Mark mark{GlFence::set(), calc::now_s()};
  mark.look();
  return mark;
}

bool DispatchPacer::Mark::look() {
  if (most_s > 0.0) return true;
  const bool is_reached = fence.is_reached();
  (is_reached ? most_s : least_s) = calc::now_s();
  return is_reached;
}

void DispatchPacer::Mark::wait(const std::string& doing) {
  if (look()) return;
  fence.wait(doing);
  least_s = most_s = calc::now_s();
}

bool DispatchPacer::has_room_for(std::size_t items) const {
  return under_way_.size() < kMostUnderWay ||
         (under_way_.size() < kMostSmallUnderWay &&
          items_under_way_ + items <= kMostUnderWay * size_.items());
}

void DispatchPacer::begin(std::size_t items, const std::string& doing) {
  while (look_at_oldest()) take_oldest();
  while (!has_room_for(items)) {
    under_way_.front().before.wait(doing);
    under_way_.front().after.wait(doing);
    take_oldest();
  }
  next_ = Mark::set();
}

void DispatchPacer::end(std::size_t items, bool teaches) {
  under_way_.push_back({std::move(next_), Mark::set(), items, teaches});
  items_under_way_ += items;
  while (look_at_oldest()) take_oldest();
}

bool DispatchPacer::look_at_oldest() {
  if (under_way_.empty()) return false;
  UnderWay& oldest = under_way_.front();
  return oldest.before.look() && oldest.after.look();
}

void DispatchPacer::take_oldest() {
  const UnderWay& oldest = under_way_.front();
  if (oldest.teaches) {
    size_.learn(oldest.items, oldest.after.least_s - oldest.before.most_s,
                oldest.after.most_s - oldest.before.least_s);
  }
  items_under_way_ -= oldest.items;
  under_way_.pop_front();
}

}  // namespace gpu
