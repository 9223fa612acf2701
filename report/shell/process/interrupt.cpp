#include "report/shell/process/interrupt.h"

#include "report/shell/process/exit_code.h"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <string_view>
#include <thread>

namespace cli {
namespace {

// Reading, making points and drawing do not ask whether to go on. Who ends a run waits no longer.
constexpr std::chrono::milliseconds kPatience{900};

std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // else not allowed in a signal handler
sem_t asked_to_end;
std::mutex ending;  // who has it ends the process, or makes sure that nobody does
bool must_finish = false;

void on_signal(int signal) {
  was_interrupted.store(true);
  std::signal(signal, SIG_DFL);  // async-signal-safe (POSIX.1-2008), and so is:
  sem_post(&asked_to_end);
}

// Each file and store entry appears whole or not at all, so the process can end at any moment but
// while several files are written that belong together.
void end_soon() {
  while (sem_wait(&asked_to_end) != 0 && errno == EINTR) {
  }
  std::this_thread::sleep_for(kPatience);
  const std::scoped_lock lock(ending);
  if (must_finish) return;
  constexpr std::string_view kWords = "luxgate: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kWords.data(), kWords.size());
  _exit(kInterrupted);
}

}  // namespace

void watch_for_interrupt() {
  static const bool is_watched = [] {
    sem_init(&asked_to_end, 0, 0);
    std::thread(end_soon).detach();
    return true;
  }();
  if (!is_watched) return;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() { return was_interrupted.load(); }

bool begin_to_write() {
  const std::scoped_lock lock(ending);
  must_finish = !interrupted();
  return must_finish;
}

}  // namespace cli
