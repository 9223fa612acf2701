#pragma once
// Records which files were read, and their state then, to detect changes without reading again.

#include "calc/base/file_reader.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace cli {

// The state of a file or folder, with links followed; all 0: there is none.
struct FileStamp {
  std::uint64_t size = 0, inode = 0;
  std::int64_t modified_ns = 0, changed_ns = 0;  // since 1970

  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::string& path);

using FileStamps = std::map<std::string, FileStamp>;  // by path, as it was asked for

// Returns the stamps that have changed.
FileStamps changed_since(const FileStamps& stamps);

// Takes the stamp of each file before it is first read, so that no change is lost.
class StampedReader : public calc::FileReader {
 public:
  explicit StampedReader(const calc::FileReader& reader) : reader_(reader) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;
  // Takes the stamp of a folder, which this does not read.
  void note(const std::string& path) const;
  FileStamps stamps() const;

 private:
  const calc::FileReader& reader_;
  mutable std::mutex mutex_;  // several projects are read at the same time
  mutable FileStamps stamps_;
};

}  // namespace cli
