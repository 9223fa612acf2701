#include "report/tools/watch/input_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace cli {
namespace {

constexpr int kQuiet_ms = 50;
constexpr int kMostUnquiet_ms = 2000;
constexpr int kLookAnyway_ms = 500;
constexpr int kAfterOthers_ms = 10;
constexpr int kAskAtMostEvery_ms = 100;

long long now_ms() {
  using std::chrono::duration_cast, std::chrono::milliseconds, std::chrono::steady_clock;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

void pause_ms(long long milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

InputWatch::InputWatch() : inotify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}

InputWatch::~InputWatch() {
  if (inotify_ >= 0) close(inotify_);
}

void InputWatch::set(const FileStamps& stamps, bool is_all) {
  if (is_all) stamps_.clear();
  for (const auto& [path, stamp] : stamps) stamps_[path] = stamp;
  if (is_all) seen_.clear();
  for (const auto& [path, stamp] : stamps_) {
    for (const std::string& folder : {folder_of(path), path}) {
      std::error_code ignored;
      if (inotify_ < 0 || !std::filesystem::is_directory(folder, ignored)) continue;
      if (!folders_.insert(folder).second) continue;
      // A folder that cannot be watched is looked at now and then.
      static_cast<void>(inotify_add_watch(inotify_, folder.c_str(),
                                          IN_CLOSE_WRITE | IN_MOVE | IN_CREATE | IN_DELETE));
    }
  }
}

bool InputWatch::has_changed() {
  const std::scoped_lock lock(mutex_);
  const long long now = now_ms();
  if (!seen_.empty() || now - asked_ms_ < kAskAtMostEvery_ms) return !seen_.empty();
  asked_ms_ = now;
  seen_ = changed_since(stamps_);
  return !seen_.empty();
}

// A file may be as its stamp says, and yet be another than the result that is shown: the run that
// took the stamp was given up for the very change.
FileStamps InputWatch::changed() const {
  FileStamps changed = changed_since(stamps_);
  for (const auto& [path, stamp] : seen_) changed.emplace(path, stamp_of(path));
  return changed;
}

bool InputWatch::sleep_ms(long long milliseconds) const {
  if (inotify_ < 0) {
    pause_ms(milliseconds);
    return false;
  }
  pollfd waiting{inotify_, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(milliseconds)) <= 0) return false;
  std::array<char, 4096> events;  // what they are about, the stamps tell
  while (read(inotify_, events.data(), events.size()) > 0) {
  }
  return true;
}

// Other files of the same folders make events, too, which must not keep this waiting.
FileStamps InputWatch::wait(const std::function<bool()>& is_stopped) {
  while (!is_stopped()) {
    FileStamps now = changed();
    if (now.empty()) {
      if (sleep_ms(kLookAnyway_ms) && changed().empty()) pause_ms(kAfterOthers_ms);
      continue;
    }
    const long long begin_ms = now_ms();
    long long last_ms = begin_ms;
    while (!is_stopped()) {
      static_cast<void>(sleep_ms(std::max(1LL, last_ms + kQuiet_ms - now_ms())));
      FileStamps again = changed();
      if (again != now) last_ms = now_ms();
      now = std::move(again);
      if (now_ms() - last_ms >= kQuiet_ms || now_ms() - begin_ms >= kMostUnquiet_ms) break;
    }
    if (now.empty() || is_stopped()) continue;
    for (const auto& [path, stamp] : now) stamps_[path] = stamp;
    seen_.clear();
    return now;
  }
  return {};
}

}  // namespace cli
