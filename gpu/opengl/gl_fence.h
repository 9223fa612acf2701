#pragma once
// A mark in the device's work, to wait for.

#include <string>
#include <utility>

namespace gpu {

// All calls, also the destructor, need the context current in which it was made. A wait for a
// device that is lost or no longer responds ends with GlError.
class GlFence {
 public:
  GlFence() = default;  // is reached
  // Returns a fence after all commands so far, and sends these.
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

  // Returns whether the device has reached it, without waiting.
  bool is_reached();
  // Waits at most this long; returns the same. doing: for messages, "gathering light".
  bool wait_for(double most_s, const std::string& doing);
  void wait(const std::string& doing);

 private:
  bool poll(double wait_s);

  void* sync_ = nullptr;   // GLsync
  double waited_s_ = 0.0;  // in vain
};

}  // namespace gpu
