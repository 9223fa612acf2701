#pragma once
// Remembers which files were read, so that no output replaces an input.

#include "calc/base/file_reader.h"

#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace cli {

class RecordingReader : public calc::FileReader {
 public:
  explicit RecordingReader(const calc::FileReader& reader) : reader_(reader) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override {
    {
      const std::scoped_lock lock(mutex_);
      if (paths_.insert(path).second) new_paths_.insert(path);
    }
    return reader_.read_within(folder, path);
  }

  // Returns the paths as requested, also of files that could not be read.
  std::set<std::string> paths() const {
    const std::scoped_lock lock(mutex_);
    return paths_;
  }
  // Returns the paths that are new since the previous call.
  std::set<std::string> new_paths() const {
    const std::scoped_lock lock(mutex_);
    return std::exchange(new_paths_, {});
  }

 private:
  const calc::FileReader& reader_;
  mutable std::mutex mutex_;  // several projects are read at the same time
  mutable std::set<std::string> paths_, new_paths_;
};

}  // namespace cli
