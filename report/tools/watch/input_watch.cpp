#include "report/tools/watch/input_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace cli {
namespace {

constexpr int kQuiet_ms = 50;
constexpr int kLookAnyway_ms = 500;
constexpr int kAskAtMostEvery_ms = 100;

long long now_ms() {
  using std::chrono::duration_cast, std::chrono::milliseconds, std::chrono::steady_clock;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
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
  has_changed_ = false;
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
  const long long now = now_ms();
  if (has_changed_ || now - asked_ms_ < kAskAtMostEvery_ms) return has_changed_;
  asked_ms_ = now;
  has_changed_ = !changed_since(stamps_).empty();
  return has_changed_;
}

bool InputWatch::sleep_ms(int milliseconds) const {
  if (inotify_ < 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    return false;
  }
  pollfd waiting{inotify_, POLLIN, 0};
  if (poll(&waiting, 1, milliseconds) <= 0) return false;
  std::array<char, 4096> events;  // what they are about, the stamps tell
  while (read(inotify_, events.data(), events.size()) > 0) {
  }
  return true;
}

FileStamps InputWatch::wait(const std::function<bool()>& is_stopped) {
  while (!is_stopped()) {
    FileStamps changed = changed_since(stamps_);
    if (changed.empty()) {
      static_cast<void>(sleep_ms(kLookAnyway_ms));
      continue;
    }
    while (!is_stopped()) {
      const bool has_happened = sleep_ms(kQuiet_ms);
      FileStamps again = changed_since(stamps_);
      const bool is_quiet = !has_happened && again == changed;
      changed = std::move(again);
      if (is_quiet) break;
    }
    if (changed.empty() || is_stopped()) continue;
    for (const auto& [path, stamp] : changed) stamps_[path] = stamp;
    has_changed_ = false;
    return changed;
  }
  return {};
}

}  // namespace cli
