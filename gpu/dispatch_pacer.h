#pragma once
// Long work as dispatches or draw calls of 25 to 50 ms: desktop drivers watch, and between two of
// them work can end early.

#include "gpu/gl_fence.h"

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
  // That so many took so long.
  void learn(std::size_t items, double seconds);

  static constexpr double kShort_s = 0.025, kLong_s = 0.05;

 private:
  std::size_t fewest_, most_, items_;
};

// Keeps a few dispatches under way, so that the device has the next before it ends one, and looks
// by fences how long each took. All calls need the context current in which it was made, the
// destructor too.
class DispatchPacer {
 public:
  explicit DispatchPacer(const DispatchSize& size) : size_(size) {}

  // For the next.
  std::size_t items() const { return size_.items(); }
  // Waits until there is room, and sends what `dispatch` calls. Throws GlError.
  template <class Dispatch>
  void run(std::size_t items, const std::string& doing, const Dispatch& dispatch) {
    begin(doing);
    dispatch();
    end(items);
  }

  static constexpr std::size_t kMostUnderWay = 2;

 private:
  struct UnderWay {
    GlFence fence;
    double begun_s;
    std::size_t items;
  };

  void begin(const std::string& doing);
  void end(std::size_t items);
  void take_oldest();

  DispatchSize size_;
  std::deque<UnderWay> under_way_;
  double begun_s_ = 0.0, reached_s_ = 0.0;  // the newest, the last that was done
};

}  // namespace gpu
