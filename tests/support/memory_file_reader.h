#pragma once
// Files that exist only in a test.

#include "calc/base/file_reader.h"

#include <map>
#include <string>
#include <utility>

namespace calc {

class MemoryFileReader : public FileReader {
 public:
  MemoryFileReader() = default;
  explicit MemoryFileReader(std::map<std::string, std::string> bytes_of_path)
      : bytes_of_path_(std::move(bytes_of_path)) {}

  void add(const std::string& path, std::string bytes) { bytes_of_path_[path] = std::move(bytes); }

  FileContent read_within(const std::string&, const std::string& path) const override {
    ++reads_[path];
    const auto found = bytes_of_path_.find(path);
    if (found == bytes_of_path_.end()) return {{}, "No such file or directory"};
    return {found->second, {}};
  }

  // How often a path was asked for.
  int reads(const std::string& path) const { return reads_[path]; }

 private:
  std::map<std::string, std::string> bytes_of_path_;
  mutable std::map<std::string, int> reads_;
};

}  // namespace calc
