#include "calc/radiosity/sampling/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace calc {

void on_threads(int jobs, const std::function<void()>& run) {
  // More than there are get no work, and the library would complain of them.
  const auto most = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  const int wanted =
      jobs > 0 ? std::min(jobs, std::max(most, 1)) : tbb::info::default_concurrency();
  const bool is_among_them =
      tbb::this_task_arena::current_thread_index() != tbb::task_arena::not_initialized &&
      tbb::this_task_arena::max_concurrency() == wanted;
  // A thread that waits for help must not take up another room meanwhile: that would hold up the
  // first, and need the memory of both.
  if (is_among_them) return tbb::this_task_arena::isolate([&run] { run(); });
  tbb::task_arena arena(wanted);
  arena.execute([&run] { run(); });
}

}  // namespace calc
