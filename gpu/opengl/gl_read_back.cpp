#include "gpu/opengl/gl_read_back.h"

#include "gpu/device/egl_context.h"
#include "gpu/opengl/gl_error.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace gpu {
namespace {

constexpr std::size_t kSmallestReadBack = 4096;

}  // namespace

GlReadBack::~GlReadBack() {
  lender_.wait();
  release();
}

void GlReadBack::release() {
  if (name_ != 0) glDeleteBuffers(1, &name_);  // ends the mapping too
  name_ = 0;
  mapped_ = nullptr;
  bytes_ = ready_ = 0;
}

void GlReadBack::reserve(std::size_t bytes) {
  if (bytes <= bytes_) return;
  bytes = std::max({bytes, bytes_ + bytes_ / 2, kSmallestReadBack});
  release();
  glGenBuffers(1, &name_);
  glBindBuffer(GL_COPY_WRITE_BUFFER, name_);
  // Written too: by start(), so that nothing that was there before passes for a result.
  constexpr GLbitfield kAccess =
      GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  glBufferStorage(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr,
                  kAccess | GL_CLIENT_STORAGE_BIT);
  check_gl("reserving memory to read " + what_);
  mapped_ = static_cast<std::byte*>(
      glMapBufferRange(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), kAccess));
  check_gl("mapping memory to read " + what_);
  if (mapped_ == nullptr) throw GlError("the device maps no memory to read " + what_);
  bytes_ = bytes;
  const EglContext& context = EglContext::current();
  if (context.messages() != nullptr) {
    context.messages()->name_buffer(name_, fmt::format("{}, read back", what_));
  }
}

void GlReadBack::start(const std::vector<Part>& parts, std::uint32_t not_done) {
  const EglContext& context = EglContext::current();
  fence_.wait("reading " + what_);  // of an earlier start() that nobody waited for
  lender_.wait();
  if (lent_ < wanted_ || not_done != not_done_) ready_ = 0;
  wanted_ = lent_ = 0;
  const bool is_lost = context.fault() == Fault::results_lost && was_used_;
  was_used_ = true;
  sources_.clear();
  fetched_.clear();
  not_done_ = not_done;
  for (const Part& part : parts) wanted_ += part.bytes;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (!context.has_buffer_storage()) {
    for (const Part& part : parts) {
      if (!is_lost) sources_.push_back({part.from.name(), part.offset, part.bytes});
    }
  } else {
    reserve(wanted_);
    if (wanted_ > ready_) {
      fill_words({mapped_ + ready_, wanted_ - ready_}, not_done);
      ready_ = wanted_;
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, name_);
    std::size_t at = 0;
    for (const Part& part : parts) {
      if (!is_lost && part.bytes > 0) {
        glBindBuffer(GL_COPY_READ_BUFFER, part.from.name());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER,
                            static_cast<GLintptr>(part.offset), static_cast<GLintptr>(at),
                            static_cast<GLsizeiptr>(part.bytes));
      }
      at += part.bytes;
    }
  }
  fence_ = GlFence::set();
}

void GlReadBack::copy(std::size_t offset, std::span<std::byte> to) const {
  if (to.empty()) return;
  if (mapped_ != nullptr) {
    if (offset + to.size() > bytes_) throw GlError("more is read than was fetched: " + what_);
    std::memcpy(to.data(), mapped_ + offset, to.size());
    return;
  }
  fill_words(to, not_done_);
  std::size_t begin = 0;  // of the source
  for (const Source& source : sources_) {
    const std::size_t first = std::max(offset, begin);
    const std::size_t last = std::min(offset + to.size(), begin + source.bytes);
    if (first < last) {
      glBindBuffer(GL_COPY_READ_BUFFER, source.name);
      glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(source.offset + first - begin),
                         static_cast<GLsizeiptr>(last - first), to.data() + (first - offset));
    }
    begin += source.bytes;
  }
}

BorrowedBytes GlReadBack::lend(std::size_t offset, std::size_t bytes) {
  if (offset + bytes > wanted_) throw GlError("more is lent than was fetched: " + what_);
  if (mapped_ == nullptr && fetched_.empty()) {
    fetched_.resize(wanted_);
    copy(0, fetched_);
  }
  lent_ += bytes;
  std::byte* const all = mapped_ != nullptr ? mapped_ : fetched_.data();
  return lender_.lend({all + offset, bytes}, not_done_);
}

}  // namespace gpu
