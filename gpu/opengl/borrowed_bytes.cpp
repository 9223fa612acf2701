#include "gpu/opengl/borrowed_bytes.h"

#include <cstring>

namespace gpu {

BorrowedBytes::~BorrowedBytes() {
  if (lender_ == nullptr) return;
  fill_words(bytes_, not_done_);
  lender_->take_back();
}

BorrowedBytes Lender::lend(std::span<std::byte> bytes, std::uint32_t not_done) {
  const std::scoped_lock lock(mutex_);
  ++lent_;
  return {*this, bytes, not_done};
}

void Lender::wait() {
  std::unique_lock lock(mutex_);
  returned_.wait(lock, [this] { return lent_ == 0; });
}

bool Lender::has_all() {
  const std::scoped_lock lock(mutex_);
  return lent_ == 0;
}

// Tells it with the mutex held: the lender may be gone as soon as that is free.
void Lender::take_back() {
  const std::scoped_lock lock(mutex_);
  if (--lent_ == 0) returned_.notify_one();
}

void fill_words(std::span<std::byte> bytes, std::uint32_t word) {
  if (word == 0x0101'0101u * (word & 0xffu)) {  // many times as fast
    std::memset(bytes.data(), static_cast<int>(word & 0xffu), bytes.size());
    return;
  }
  std::size_t k = 0;
  for (; k + sizeof word <= bytes.size(); k += sizeof word) {
    std::memcpy(bytes.data() + k, &word, sizeof word);
  }
  std::memcpy(bytes.data() + k, &word, bytes.size() - k);
}

}  // namespace gpu
