#include "gpu/gl_buffer.h"

#include "gpu/gl_error.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gpu {
namespace {

constexpr std::size_t kSmallest = 4096;  // an empty array can be bound like any other

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

}  // namespace

GlBuffer::GlBuffer(std::string what) : what_(std::move(what)) { glGenBuffers(1, &name_); }

GlBuffer::GlBuffer(GlBuffer&& other) noexcept
    : what_(std::move(other.what_)),
      name_(std::exchange(other.name_, 0)),
      bytes_(std::exchange(other.bytes_, 0)) {}

GlBuffer::~GlBuffer() {
  if (name_ != 0) glDeleteBuffers(1, &name_);
}

void GlBuffer::reserve(std::size_t bytes) {
  bytes = std::max(bytes, kSmallest);
  if (bytes <= bytes_) return;
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (bytes > static_cast<std::size_t>(most)) {
    throw OutOfMemory(fmt::format("{} need {:.0f} MiB in one buffer, the device allows {:.0f}",
                                  what_, mebibytes(bytes), mebibytes(std::size_t(most))));
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
  bytes_ = 0;
  check_gl(fmt::format("reserving {:.1f} MiB for {}", mebibytes(bytes), what_));
  bytes_ = bytes;
}

void GlBuffer::write(std::size_t offset, std::span<const std::byte> from) {
  if (from.empty()) return;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                  static_cast<GLsizeiptr>(from.size()), from.data());
}

void GlBuffer::read(std::size_t offset, std::span<std::byte> to) const {
  if (to.empty()) return;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                     static_cast<GLsizeiptr>(to.size()), to.data());
}

void GlBuffer::fill(std::size_t bytes, std::uint32_t value) {
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, static_cast<GLsizeiptr>(bytes),
                       GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
}

void GlBuffer::bind(unsigned binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name_);
}

}  // namespace gpu
