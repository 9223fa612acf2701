#pragma once
// Waits for a change of files.

#include "report/tools/watch/file_stamps.h"

#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace cli {

// Watches by inotify the folders that contain the files, because editors replace old files by new
// ones. Changes that inotify does not report (files of another machine, targets of links) are seen
// within half a second.
class InputWatch {
 public:
  InputWatch();
  ~InputWatch();
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

  // Sets the watched files. is_all: only these; otherwise the previous ones stay.
  void set(const FileStamps& stamps, bool is_all);
  // Returns whether one of them has changed. Reads the disk at most ten times a second. Any number
  // of threads may call at once. After a change it stays true until set() of all or wait().
  bool has_changed();
  // Waits until a file changes, or has changed according to has_changed(), and then nothing more
  // happens for 50 ms, or changes continue for 2 s. Returns the changes, which become the known
  // state. Empty once is_stopped().
  FileStamps wait(const std::function<bool()>& is_stopped);

 private:
  FileStamps changed() const;
  // Waits at most this long for an event in a folder; returns whether there was one.
  bool sleep_ms(long long milliseconds) const;

  int inotify_ = -1;
  std::set<std::string> folders_;
  std::mutex mutex_;  // of has_changed()
  FileStamps stamps_;
  long long asked_ms_ = 0;
  FileStamps seen_;  // what has_changed() told of
};

}  // namespace cli
