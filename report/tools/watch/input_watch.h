#pragma once
// Waits for a change of files.

#include "report/tools/watch/file_stamps.h"

#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace cli {

// By inotify, on the folders that the files are in, as editors put new files in place of old ones.
// What inotify does not tell of (files of another machine, targets of links) is seen within half a
// second.
class InputWatch {
 public:
  InputWatch();
  ~InputWatch();
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

  // From now on these. is_all: and no others; else those that it had stay.
  void set(const FileStamps& stamps, bool is_all);
  // Whether one of them is not as it was. Asks the disk at most ten times a second. Any number of
  // threads may ask at once. Once it was, it stays so until set() of all or wait().
  bool has_changed();
  // Until one of them is not as it was, or was not when has_changed() said so, and then nothing has
  // happened to them for 50 ms, or something all the time for 2 s: what has changed, which from now
  // on is how they are. Empty once is_stopped().
  FileStamps wait(const std::function<bool()>& is_stopped);

 private:
  FileStamps changed() const;
  // Until something has happened in a folder: whether it has. At most so long.
  bool sleep_ms(long long milliseconds) const;

  int inotify_ = -1;
  std::set<std::string> folders_;
  std::mutex mutex_;  // of has_changed()
  FileStamps stamps_;
  long long asked_ms_ = 0;
  FileStamps seen_;  // what has_changed() told of
};

}  // namespace cli
