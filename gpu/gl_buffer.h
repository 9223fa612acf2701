#pragma once
// An array on the device that shaders read or write.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace gpu {

// All calls need the context current in which it was made, the destructor too. They throw GlError.
class GlBuffer {
 public:
  // what: for messages, "light vertices".
  explicit GlBuffer(std::string what);
  ~GlBuffer();
  GlBuffer(GlBuffer&& other) noexcept;
  GlBuffer& operator=(GlBuffer&&) = delete;
  GlBuffer(const GlBuffer&) = delete;
  GlBuffer& operator=(const GlBuffer&) = delete;

  // At least so many bytes; what was there is lost if it has to grow.
  void reserve(std::size_t bytes);
  std::size_t bytes() const { return bytes_; }
  unsigned name() const { return name_; }  // of OpenGL, for arrays that are drawn from
  void write(std::size_t offset, std::span<const std::byte> from);
  void read(std::size_t offset, std::span<std::byte> to) const;
  // reserve() and write() of a whole array: a vector or a span.
  template <class Items>
  void assign(const Items& items) {
    const auto bytes = std::as_bytes(std::span(items));
    reserve(bytes.size());
    write(0, bytes);
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
  std::string what_;
  unsigned name_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace gpu
