#include "report/shell/interrupt.h"

#include <atomic>
#include <csignal>

namespace cli {
namespace {

std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // else not allowed in a signal handler

void on_signal(int signal) {
  was_interrupted.store(true);
  std::signal(signal, SIG_DFL);  // async-signal-safe (POSIX.1-2008)
}

}  // namespace

void watch_for_interrupt() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() { return was_interrupted.load(); }

}  // namespace cli
