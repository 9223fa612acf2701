#pragma once
// Writes files whole or not at all.

#include "report/stream/sink.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Writes beside the target under a temporary name, flushes to the disk and renames; creates missing
// parent folders. Removes temporary files there that a killed run has left for the same target. On
// failure the target is unchanged, no temporary file remains, and the reason is returned; "" is
// success. A symbolic link is followed; devices and pipes ("/dev/stdout") are written directly.
// Threads and processes may write the same target at once: one of the whole files wins.
std::string write_file_atomically(const std::string& path, std::string_view bytes);
// Writes a file piece by piece in the same way. make may throw: exceptions pass on, except a
// WriteFailure, which becomes the reason of the failure.
std::string write_file_atomically(const std::string& path, const std::function<void(Sink&)>& make);

class WaitingFile;

// Files that belong together: each is written whole beside its target, and at the end all are moved
// into place with nothing between the renames. Devices and pipes are written directly.
class FileSet {
 public:
  FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;
  ~FileSet();  // of what was not published nothing stays behind

  // Returns "", or the reason of a failure, as write_file_atomically() does.
  std::string add(const std::string& path, const std::function<void(Sink&)>& make);
  // Moves the files into place, once. Returns a message "cannot write ..." for each failure; the
  // paths of the others are appended to `published`.
  std::vector<std::string> publish(std::vector<std::string>& published);

 private:
  std::vector<std::unique_ptr<WaitingFile>> waiting_;
};

}  // namespace report
