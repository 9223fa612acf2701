#pragma once
// Long work as dispatches or draw calls of 25 to 50 ms: desktop drivers watch, and between two of
// them work can end early.

#include "gpu/opengl/gl_fence.h"

#include <cstddef>
#include <deque>
#include <string>

namespace gpu {

// How many items a dispatch is to have, by what earlier ones took. Never changes a result.
class DispatchSize {
 public:
  DispatchSize(std::size_t fewest, std::size_t most, std::size_t first)
      : fewest_(fewest), most_(most), items_(first) {}

  std::size_t items() const { return items_; }
  // That so many took no less than `least_s` and no more than `most_s`.
  void learn(std::size_t items, double least_s, double most_s);

  static constexpr double kShort_s = 0.025, kLong_s = 0.05;

 private:
  std::size_t fewest_, most_, items_;
};

// Keeps a few dispatches under way, so that the device has the next before it ends one, and finds
// by fences how long each took: from when it had its turn, as others' work may be on the device.
// All calls need the context current in which it was made, the destructor too.
class DispatchPacer {
 public:
  explicit DispatchPacer(const DispatchSize& size) : size_(size) {}

  // For the next.
  std::size_t items() const { return size_.items(); }
  // Waits until there is room, and sends what `dispatch` calls. teaches: nothing but the items
  // takes time in it. Throws GlError.
  template <class Dispatch>
  void run(std::size_t items, const std::string& doing, const Dispatch& dispatch,
           bool teaches = true) {
    begin(items, doing);
    dispatch();
    end(items, teaches);
  }

  // Dispatches of items() each; or more, of smaller ones.
  static constexpr std::size_t kMostUnderWay = 2, kMostSmallUnderWay = 32;

 private:
  // When the device got somewhere. Nobody may have looked just then.
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
