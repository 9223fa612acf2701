#pragma once
// Memory of one thread that others borrow in parts; it is used again once all parts are back.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>

namespace gpu {

class Lender;

// A part of it. Whoever destroys it, on any thread, gives it back, with every word "not done": what
// is not overwritten then cannot pass for a result.
class BorrowedBytes {
 public:
  BorrowedBytes() = default;
  ~BorrowedBytes();
  BorrowedBytes(BorrowedBytes&& other) noexcept
      : lender_(std::exchange(other.lender_, nullptr)),
        bytes_(std::exchange(other.bytes_, {})),
        not_done_(other.not_done_) {}
  BorrowedBytes& operator=(BorrowedBytes&& other) noexcept {
    std::swap(lender_, other.lender_);
    std::swap(bytes_, other.bytes_);
    std::swap(not_done_, other.not_done_);
    return *this;
  }
  BorrowedBytes(const BorrowedBytes&) = delete;
  BorrowedBytes& operator=(const BorrowedBytes&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  friend Lender;
  BorrowedBytes(Lender& lender, std::span<std::byte> bytes, std::uint32_t not_done)
      : lender_(&lender), bytes_(bytes), not_done_(not_done) {}

  Lender* lender_ = nullptr;
  std::span<std::byte> bytes_;
  std::uint32_t not_done_ = 0;
};

// Outlives its lent parts: its destructor waits. The owner's thread must not hold any part then,
// nor in wait().
class Lender {
 public:
  Lender() = default;
  ~Lender() { wait(); }
  Lender(const Lender&) = delete;
  Lender& operator=(const Lender&) = delete;

  BorrowedBytes lend(std::span<std::byte> bytes, std::uint32_t not_done);
  // Until all is back.
  void wait();
  bool has_all();

 private:
  friend BorrowedBytes;
  void take_back();

  std::mutex mutex_;
  std::condition_variable returned_;
  std::size_t lent_ = 0;
};

// Fills every 4 bytes, and the rest in part.
void fill_words(std::span<std::byte> bytes, std::uint32_t word);

}  // namespace gpu
