#pragma once
// Shares sets of buffers among simultaneous calls: each takes a set, the others wait.

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace gpu {

template <class Buffers>
class BufferSets {
 public:
  // A set, until it is destroyed. Of the caller's thread, but for buffers().
  class BufferSet {
   public:
    ~BufferSet() {
      if (owner_ != nullptr) owner_->put_back(number_);
    }
    BufferSet(BufferSet&& other) noexcept
        : owner_(std::exchange(other.owner_, nullptr)), number_(other.number_) {}
    BufferSet& operator=(BufferSet&& other) noexcept {
      std::swap(owner_, other.owner_);
      std::swap(number_, other.number_);
      return *this;
    }
    BufferSet(const BufferSet&) = delete;
    BufferSet& operator=(const BufferSet&) = delete;

    // Returns the buffers with an earlier call's contents, or new. For the context's thread.
    Buffers& buffers() const {
      std::unique_ptr<Buffers>& made = owner_->sets_[number_];
      if (!made) made = std::make_unique<Buffers>();
      return *made;
    }

   private:
    friend BufferSets;
    BufferSet(BufferSets& owner, std::size_t number) : owner_(&owner), number_(number) {}

    BufferSets* owner_;
    std::size_t number_;
  };

  explicit BufferSets(std::size_t sets) : sets_(sets) {
    for (std::size_t k = 0; k < sets; ++k) free_.push_back(k);
  }

  // Waits for one. Whoever waits must hold none.
  BufferSet take() {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return !free_.empty(); });
    return next();
  }
  // If there is one.
  std::optional<BufferSet> try_take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) return std::nullopt;
    return next();
  }
  // Frees the unused sets; others stay. For the context's thread.
  void clear() {
    const std::scoped_lock lock(mutex_);
    for (const std::size_t k : free_) sets_[k].reset();
  }

 private:
  BufferSet next() {
    const std::size_t number = free_.back();
    free_.pop_back();
    return {*this, number};
  }
  void put_back(std::size_t number) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(number);
    freed_.notify_one();
  }

  std::vector<std::unique_ptr<Buffers>> sets_;  // made when first needed
  std::mutex mutex_;
  std::condition_variable freed_;
  std::vector<std::size_t> free_;
};

}  // namespace gpu
