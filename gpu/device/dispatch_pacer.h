#pragma once
// Splits long work into dispatches or draw calls of 25 to 50 ms, because desktop drivers have
// watchdogs, and so that work can end early between two of them.

#include "gpu/opengl/gl_fence.h"

#include <cstddef>
#include <deque>
#include <string>

namespace gpu {

// The number of items of a dispatch, from the times of earlier ones. Never changes a result.
class DispatchSize {
 public:
  DispatchSize(std::size_t fewest, std::size_t most, std::size_t first)
      : fewest_(fewest), most_(most), items_(first) {}

  std::size_t items() const { return items_; }
  // Learns that so many took no less than `least_s` and no more than `most_s`.
  void learn(std::size_t items, double least_s, double most_s);

  static constexpr double kShort_s = 0.025, kLong_s = 0.05;

 private:
  std::size_t fewest_, most_, items_;
};

// Keeps a few dispatches under way, so that the device has the next before it ends one, and
// measures by fences how long each took: from the start of its turn, as others' work may be on the
// device. All calls, also the destructor, need the context current in which it was made.
class DispatchPacer {
 public:
  explicit DispatchPacer(const DispatchSize& size) : size_(size) {}

  // Returns the items of the next dispatch.
  std::size_t items() const { return size_.items(); }
  // Waits until there is room, and runs `dispatch`. teaches: only the items take time in it. Throws
  // GlError.
  template <class Dispatch>
  void run(std::size_t items, const std::string& doing, const Dispatch& dispatch,
           bool teaches = true) {
    begin(items, doing);
    dispatch();
    end(items, teaches);
  }

  // Limits for dispatches of items() each; or more, of smaller ones.
  static constexpr std::size_t kMostUnderWay = 2, kMostSmallUnderWay = 32;

 private:
  // The time at which the device reached a fence; it is a range, because no thread may have polled.
  struct Mark {
    GlFence fence;
    double least_s = 0.0, most_s = 0.0;  // 0: not yet

    static Mark set();
    bool look();
    void wait(const std::string& doing);
  };
  struct UnderWay {
    Mark before, after;
    std::size_t items;
    bool teaches;
  };

  bool has_room_for(std::size_t items) const;
  void begin(std::size_t items, const std::string& doing);
  void end(std::size_t items, bool teaches);
  bool look_at_oldest();
  void take_oldest();

  DispatchSize size_;
  std::deque<UnderWay> under_way_;
  std::size_t items_under_way_ = 0;
  Mark next_;  // before the next
};

}  // namespace gpu
