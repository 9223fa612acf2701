#pragma once
// Reading files behind an interface, so that loaders can be tested without a disk.

#include <string>

namespace calc {

// What a read gave: the bytes, or a reason in words ("No such file or directory").
struct FileContent {
  std::string bytes;
  std::string error;  // empty = success

  bool ok() const { return error.empty(); }
};

class FileReader {
 public:
  virtual ~FileReader() = default;
  virtual FileContent read(const std::string& path) const = 0;
};

// Reads regular files from disk; folders, devices and files over 512 MiB are refused with a reason.
class DiskFileReader : public FileReader {
 public:
  FileContent read(const std::string& path) const override;
};

}  // namespace calc
