#pragma once
// Waits for a change of files.

#include "report/tools/watch/file_stamps.h"

#include <functional>
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
  // Whether one of them is not as it was. Asks the disk at most ten times a second.
  bool has_changed();
  // Until one of them is not as it was, and then nothing has happened to them for 50 ms: what has
  // changed, which from now on is how they are. Empty once is_stopped().
  FileStamps wait(const std::function<bool()>& is_stopped);

 private:
  // Whether something has happened in a folder; at most so long.
  bool sleep_ms(int milliseconds) const;

  int inotify_ = -1;
  std::set<std::string> folders_;
  FileStamps stamps_;
  long long asked_ms_ = 0;
  bool has_changed_ = false;
};

}  // namespace cli
