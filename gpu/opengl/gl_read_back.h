#pragma once
// Transfers results back beside other work of the device.

#include "gpu/opengl/borrowed_bytes.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_fence.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gpu {

// All calls, also the destructor, need the context of its creation current. They throw GlError.
//
// The device copies into memory of the program that stays mapped, so that neither waits for the
// other and no buffer of shaders has to leave the device. Without buffer storage (OpenGL 4.4)
// copy() and lend() read the buffers themselves, which must not have changed by then.
class GlReadBack {
 public:
  struct Part {
    const GlBuffer& from;
    std::size_t offset, bytes;
  };

  // what: for messages, "sums".
  explicit GlReadBack(std::string what) : what_(std::move(what)) {}
  ~GlReadBack();
  GlReadBack(const GlReadBack&) = delete;
  GlReadBack& operator=(const GlReadBack&) = delete;

  // Fetches some parts, one behind the other, after all commands so far. Data of an earlier start()
  // is lost: data that does not arrive reads as not_done. Waits for lent parts.
  void start(const std::vector<Part>& parts, std::uint32_t not_done);
  // Wait like GlFence.
  bool wait_for(double most_s, const std::string& doing) { return fence_.wait_for(most_s, doing); }
  void wait(const std::string& doing) { fence_.wait(doing); }
  // Copies results; requires wait() before.
  void copy(std::size_t offset, std::span<std::byte> to) const;
  // After wait(): the same for another thread, without a copy; no byte twice. What comes back is
  // ready for the next start().
  BorrowedBytes lend(std::size_t offset, std::size_t bytes);
  // Whether start() would not wait for what is lent.
  bool has_all() { return lender_.has_all(); }
  // Returns the bytes that start() can fetch without more memory.
  std::size_t room_bytes() const { return bytes_; }

 private:
  struct Source {
    unsigned name;
    std::size_t offset, bytes;
  };

  void reserve(std::size_t bytes);
  void release();

  std::string what_;
  GlFence fence_;
  unsigned name_ = 0;
  std::byte* mapped_ = nullptr;
  std::size_t bytes_ = 0;
  std::vector<Source> sources_;     // without buffer storage
  std::vector<std::byte> fetched_;  // the same, for lend()
  std::uint32_t not_done_ = ~0u;
  std::size_t wanted_ = 0, lent_ = 0;  // bytes of this start()
  // Bytes from the start of the mapping that are all not_done again once lent parts are back.
  std::size_t ready_ = 0;
  bool was_used_ = false;  // for Fault::results_lost
  Lender lender_;          // last: what is lent outlives nothing above
};

}  // namespace gpu
