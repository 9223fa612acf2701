#pragma once
// Remembers which files were read, so that no output takes the place of an input.

#include "calc/base/file_reader.h"

#include <set>
#include <string>

namespace cli {

class RecordingReader : public calc::FileReader {
 public:
  explicit RecordingReader(const calc::FileReader& reader) : reader_(reader) {}

  calc::FileContent read(const std::string& path) const override {
    paths_.insert(path);
    return reader_.read(path);
  }

  // As they were asked for, also those that could not be read.
  const std::set<std::string>& paths() const { return paths_; }

 private:
  const calc::FileReader& reader_;
  mutable std::set<std::string> paths_;
};

}  // namespace cli
