#include "gpu/opengl/gl_buffer.h"

#include "gpu/device/egl_context.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/opengl/gl_read_back.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace gpu {
namespace {

constexpr std::size_t kSmallestBuffer = 4096;  // an empty array can be bound like any other

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

}  // namespace

GlBuffer::GlBuffer(std::string what, BufferUse use) : what_(std::move(what)), use_(use) {
  glGenBuffers(1, &name_);
}

GlBuffer::GlBuffer(GlBuffer&& other) noexcept
    : what_(std::move(other.what_)),
      use_(other.use_),
      name_(std::exchange(other.name_, 0)),
      bytes_(std::exchange(other.bytes_, 0)),
      read_back_(std::move(other.read_back_)) {}

GlBuffer::~GlBuffer() {
  if (name_ != 0) glDeleteBuffers(1, &name_);
}

void GlBuffer::reserve(std::size_t bytes) {
  bytes = std::max(bytes, kSmallestBuffer);
  if (bytes <= bytes_) return;
  const std::size_t most = largest_for(bytes);
  // Storage is made once: what grows a little with each piece is not to be made anew each time.
  allocate(std::max(bytes, std::min(bytes_ + bytes_ / 2, most)), nullptr);
}

// The largest that the device allows; throws if that is too small.
std::size_t GlBuffer::largest_for(std::size_t bytes) const {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  if (bytes > static_cast<std::size_t>(most)) {
    throw OutOfMemory(fmt::format("{} need {:.0f} MiB in one buffer, the device allows {:.0f}",
                                  what_, mebibytes(bytes), mebibytes(std::size_t(most))));
  }
  return static_cast<std::size_t>(most);
}

// data: what is there from the beginning, null = anything.
void GlBuffer::allocate(std::size_t bytes, const std::byte* data) {
  const EglContext& context = EglContext::current();
  bytes_ = 0;
  const auto size = static_cast<GLsizeiptr>(bytes);
  if (context.has_buffer_storage()) {
    glDeleteBuffers(1, &name_);
    glGenBuffers(1, &name_);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
    glBufferStorage(GL_SHADER_STORAGE_BUFFER, size, data,
                    use_ == BufferUse::rewritten ? GL_DYNAMIC_STORAGE_BIT : 0);
  } else {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, size, data, GL_DYNAMIC_DRAW);
  }
  check_gl(fmt::format("reserving {:.1f} MiB for {}", mebibytes(bytes), what_));
  bytes_ = bytes;
  if (context.messages() != nullptr) context.messages()->name_buffer(name_, what_);
}

void GlBuffer::assign_bytes(std::span<const std::byte> from) {
  if (use_ != BufferUse::fixed) {
    reserve(from.size());
    write(0, from);
    return;
  }
  if (from.size() >= kSmallestBuffer) {
    largest_for(from.size());
    allocate(from.size(), from.data());
    return;
  }
  std::vector<std::byte> padded(from.begin(), from.end());
  padded.resize(kSmallestBuffer);
  allocate(padded.size(), padded.data());
}

void GlBuffer::write(std::size_t offset, std::span<const std::byte> from) {
  if (from.empty()) return;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                  static_cast<GLsizeiptr>(from.size()), from.data());
}

void GlBuffer::read(std::size_t offset, std::span<std::byte> to) const {
  if (to.empty()) return;
  if (!read_back_) read_back_ = std::make_unique<GlReadBack>(what_);
  read_back_->start({{*this, offset, to.size()}}, ~0u);
  read_back_->wait("reading " + what_);
  read_back_->copy(0, to);
}

void GlBuffer::fill(std::size_t bytes, std::uint32_t value) {
  if (bytes == 0) return;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, name_);
  glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, static_cast<GLsizeiptr>(bytes),
                       GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
}

void GlBuffer::bind(unsigned binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name_);
}

}  // namespace gpu
