#pragma once
// Sets of buffers for calls that are under way at the same time: each takes one, the others wait.

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace gpu {

template <class Buffers>
class Turns {
 public:
  // A set, until it is destroyed. Of the caller's thread, but for buffers().
  class Turn {
   public:
    ~Turn() {
      if (turns_ != nullptr) turns_->put_back(number_);
    }
    Turn(Turn&& other) noexcept
        : turns_(std::exchange(other.turns_, nullptr)), number_(other.number_) {}
    Turn& operator=(Turn&& other) noexcept {
      std::swap(turns_, other.turns_);
      std::swap(number_, other.number_);
      return *this;
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    // On the context's thread. What an earlier call left, or what clear() left of it.
    Buffers& buffers() const {
      std::unique_ptr<Buffers>& made = turns_->sets_[number_];
      if (!made) made = std::make_unique<Buffers>();
      return *made;
    }

   private:
    friend Turns;
    Turn(Turns& turns, std::size_t number) : turns_(&turns), number_(number) {}

    Turns* turns_;
    std::size_t number_;
  };

  explicit Turns(std::size_t sets) : sets_(sets) {
    for (std::size_t k = 0; k < sets; ++k) free_.push_back(k);
  }

  // Waits for one. Whoever waits must hold none.
  Turn take() {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return !free_.empty(); });
    return next();
  }
  // If there is one.
  std::optional<Turn> try_take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) return std::nullopt;
    return next();
  }
  // On the context's thread: of sets that nobody has; others go on with theirs.
  void clear() {
    const std::scoped_lock lock(mutex_);
    for (const std::size_t k : free_) sets_[k].reset();
  }

 private:
  Turn next() {
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
