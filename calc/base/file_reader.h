#pragma once
// Reading files behind an interface, so that loaders can be tested without a disk.

#include <string>
#include <utility>
#include <vector>

namespace calc {

// The result of a read: the bytes, or a reason in words ("No such file or directory").
struct FileContent {
  std::string bytes;
  std::string error;        // empty = success
  bool is_outside = false;  // the error: a link leads out of the folder that it had to lie in

  bool ok() const { return error.empty(); }
};

class FileReader {
 public:
  virtual ~FileReader() = default;
  FileContent read(const std::string& path) const { return read_within("", path); }
  // Reads a path that comes from a file, perhaps an untrusted one: it must be in this folder or
  // below it, links followed; "" = anywhere. Readers of their own files use read().
  virtual FileContent read_within(const std::string& folder, const std::string& path) const = 0;
};

// Reads regular files from disk; folders, devices, pipes and files over 512 MiB are refused with a
// reason. For a file that is not there the reason names the one that differs in letter case or
// slashes only, anywhere in its path, else one of its folder that is spelt alike.
class DiskFileReader : public FileReader {
 public:
  // allowed: further folders that links may lead into.
  explicit DiskFileReader(std::vector<std::string> allowed = {}) : allowed_(std::move(allowed)) {}

  FileContent read_within(const std::string& folder, const std::string& path) const override;

 private:
  std::vector<std::string> allowed_;
};

}  // namespace calc
