#include "report/check/in_order.h"

#include "calc/radiosity/sampling/threads.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace check {

void in_order(std::size_t count, const Concurrency& concurrency,
              const std::function<void(std::size_t)>& work,
              const std::function<void(std::size_t)>& deliver, const std::function<bool()>& go_on) {
  if (count <= 1 || concurrency.most_begun <= 1) {
    for (std::size_t i = 0; i < count && go_on(); ++i) {
      work(i);
      deliver(i);
    }
    return;
  }
  std::size_t next = 0;
  const auto begin = [&](tbb::flow_control& control) {
    if (next == count || !go_on()) {
      control.stop();
      return count;
    }
    return next++;
  };
  // A thread that waits for help with its piece must not take up another one meanwhile: that would
  // hold up the first, and need the memory of both.
  const auto do_work = [&](std::size_t i) {
    tbb::this_task_arena::isolate([&] { work(i); });
    return i;
  };
  calc::on_threads(concurrency.threads, [&] {
    tbb::parallel_pipeline(
        concurrency.most_begun,
        tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, begin) &
            tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, do_work) &
            tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, deliver));
  });
}

}  // namespace check
