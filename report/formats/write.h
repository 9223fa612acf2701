#pragma once
// Files appear whole or not at all.

#include "report/stream/sink.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Writes beside the target under a temporary name, flushes to the disk and renames; missing parent
// folders are created. Temporary files there that a killed run has left for the same target are
// removed. On failure the target is as it was, nothing temporary stays behind, and the
// reason is returned; "" is success. A symbolic link is followed; devices and pipes ("/dev/stdout")
// are written directly. Threads and processes may write the same target at once: one of the whole
// files wins.
std::string write_file_atomically(const std::string& path, std::string_view bytes);
// The same piece by piece. make may throw: what is thrown goes on, but a WriteFailure, which is the
// reason of a failure.
std::string write_file_atomically(const std::string& path, const std::function<void(Sink&)>& make);

class WaitingFile;

// Files that belong together: each is written whole beside its target, and all of them take their
// places at once at the end, with nothing between them but renames. Devices and pipes are written
// directly.
class FileSet {
 public:
  FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;
  ~FileSet();  // of what was not published nothing stays behind

  // "", or why not; as write_file_atomically().
  std::string add(const std::string& path, const std::function<void(Sink&)>& make);
  // Once. A message "cannot write ..." for each that could not take its place; the paths of the
  // others are appended to `published`.
  std::vector<std::string> publish(std::vector<std::string>& published);

 private:
  std::vector<std::unique_ptr<WaitingFile>> waiting_;
};

}  // namespace report
