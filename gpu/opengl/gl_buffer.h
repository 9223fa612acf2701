#pragma once
// An array on the device that shaders read or write.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace gpu {

class GlReadBack;

// The writer of a buffer, by which drivers place it.
enum class BufferUse {
  rewritten,  // the program, again and again
  fixed,      // the program, once: assign() alone, each makes it anew
  by_device   // shaders and fill() alone
};

// All calls, also the destructor, need the context of its creation current. They throw GlError.
class GlBuffer {
 public:
  // what: for messages, "light vertices".
  explicit GlBuffer(std::string what, BufferUse use = BufferUse::rewritten);
  ~GlBuffer();
  GlBuffer(GlBuffer&& other) noexcept;
  GlBuffer& operator=(GlBuffer&&) = delete;
  GlBuffer(const GlBuffer&) = delete;
  GlBuffer& operator=(const GlBuffer&) = delete;

  // Makes room for at least so many bytes; its contents are lost if it has to grow.
  void reserve(std::size_t bytes);
  std::size_t bytes() const { return bytes_; }
  unsigned name() const { return name_; }  // of OpenGL, changes when it grows
  void write(std::size_t offset, std::span<const std::byte> from);
  // Reads after waiting for all the device's commands. Missing data is set to ~0; for results, or
  // to do other work meanwhile, use GlReadBack.
  void read(std::size_t offset, std::span<std::byte> to) const;
  // Does reserve() and write() of a whole array: a vector or a span.
  template <class Items>
  void assign(const Items& items) {
    assign_bytes(std::as_bytes(std::span(items)));
  }
  // Does reserve() and fill().
  void assign(std::size_t bytes, std::uint32_t value) {
    reserve(bytes);
    fill(bytes, value);
  }
  // Fills every 4 bytes of the first `bytes`, a multiple of 4.
  void fill(std::size_t bytes, std::uint32_t value);
  // Binds it to layout(std430, binding = ...).
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
