#pragma once
// Pieces of work by several threads, and their results one after the other.

#include <cstddef>
#include <functional>

namespace check {

// How many threads, and how many pieces at once. Neither ever changes a result.
struct Concurrency {
  int threads = 0;  // 0: one per core
  // At most so many pieces are begun and not yet delivered, which bounds the memory of results that
  // wait for an earlier one. 1: one after the other, and all threads work on each.
  std::size_t most_begun = 1;
};

// Calls work(i) for i = 0 .. count-1, several at a time, and deliver(i) in the order of i, one at a
// time, each soon after all before it. go_on is asked before a piece is begun; once it is false no
// more are, and what was begun is finished and delivered. All three may be called on any thread.
// Threads without a piece of their own help with what other pieces have in parallel. Passes on the
// first exception.
void in_order(std::size_t count, const Concurrency& concurrency,
              const std::function<void(std::size_t)>& work,
              const std::function<void(std::size_t)>& deliver, const std::function<bool()>& go_on);

}  // namespace check
