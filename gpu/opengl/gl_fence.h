#pragma once
// A mark in the device's work, to wait for.

#include <string>
#include <utility>

namespace gpu {

// All calls need the context current in which it was made, the destructor too. A device that is
// lost, or says nothing any more, ends a wait by GlError.
class GlFence {
 public:
  GlFence() = default;  // is reached
  // After all commands so far, which it sends on their way.
  static GlFence set();
  ~GlFence();
  GlFence(GlFence&& other) noexcept
      : sync_(std::exchange(other.sync_, nullptr)), waited_s_(other.waited_s_) {}
  GlFence& operator=(GlFence&& other) noexcept {
    std::swap(sync_, other.sync_);
    std::swap(waited_s_, other.waited_s_);
    return *this;
  }
  GlFence(const GlFence&) = delete;
  GlFence& operator=(const GlFence&) = delete;

  // Whether the device has got there. Does not wait.
  bool is_reached();
  // Waits so long at most; the same answer. doing: for messages, "gathering light".
  bool wait_for(double most_s, const std::string& doing);
  void wait(const std::string& doing);

 private:
  bool poll(double wait_s);

  void* sync_ = nullptr;   // GLsync
  double waited_s_ = 0.0;  // in vain
};

}  // namespace gpu
