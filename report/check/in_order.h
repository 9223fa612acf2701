#pragma once
// Runs pieces of work on several threads and delivers their results in order.

#include <cstddef>
#include <functional>

namespace check {

// The numbers of threads and of pieces at the same time. Neither ever changes a result.
struct Concurrency {
  int threads = 0;  // 0: one per core
  // At most this many pieces are begun and not yet delivered, which bounds the memory of results
  // that wait for an earlier one. 1: one after the other, with all threads on each.
  std::size_t most_begun = 1;
};

// Calls work(i) for i = 0 .. count-1, several at a time, and deliver(i) in the order of i, one at a
// time, each soon after all before it. go_on is called before each piece begins; after false none
// begins, and begun pieces are finished and delivered. All three may be called on any thread.
// Threads without a piece of their own help inside other pieces. Passes on the first exception.
void in_order(std::size_t count, const Concurrency& concurrency,
              const std::function<void(std::size_t)>& work,
              const std::function<void(std::size_t)>& deliver, const std::function<bool()>& go_on);

}  // namespace check
