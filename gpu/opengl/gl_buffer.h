#pragma once
// An array on the device that shaders read or write.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace gpu {

class GlReadBack;

// Who writes a buffer: drivers place it by that, and must not guess.
enum class BufferUse {
  rewritten,  // the program, again and again
  fixed,      // the program, once: assign() alone, each makes it anew
  by_device   // shaders and fill() alone
};

// All calls need the context current in which it was made, the destructor too. They throw GlError.
class GlBuffer {
 public:
  // what: for messages, "light vertices".
  explicit GlBuffer(std::string what, BufferUse use = BufferUse::rewritten);
  ~GlBuffer();
  GlBuffer(GlBuffer&& other) noexcept;
  GlBuffer& operator=(GlBuffer&&) = delete;
  GlBuffer(const GlBuffer&) = delete;
  GlBuffer& operator=(const GlBuffer&) = delete;

  // At least so many bytes; what was there is lost if it has to grow.
  void reserve(std::size_t bytes);
  std::size_t bytes() const { return bytes_; }
  unsigned name() const { return name_; }  // of OpenGL, changes when it grows
  void write(std::size_t offset, std::span<const std::byte> from);
  // Waits for all that the device has been told. What does not come back is set to ~0: where that
  // is a result, or something is to be done meanwhile, use GlReadBack.
  void read(std::size_t offset, std::span<std::byte> to) const;
  // reserve() and write() of a whole array: a vector or a span.
  template <class Items>
  void assign(const Items& items) {
    assign_bytes(std::as_bytes(std::span(items)));
  }
  // reserve() and fill().
  void assign(std::size_t bytes, std::uint32_t value) {
    reserve(bytes);
    fill(bytes, value);
  }
  // Every 4 bytes of the first `bytes`, a multiple of 4.
  void fill(std::size_t bytes, std::uint32_t value);
  // layout(std430, binding = ...)
  void bind(unsigned binding) const;

 private:
  void assign_bytes(std::span<const std::byte> from);
  std::size_t largest_for(std::size_t bytes) const;
  void allocate(std::size_t bytes, const std::byte* data);

  std::string what_;
  BufferUse use_;
  unsigned name_ = 0;
  std::size_t bytes_ = 0;
  mutable std::unique_ptr<GlReadBack> read_back_;  // of read(), made when first needed
};

}  // namespace gpu
