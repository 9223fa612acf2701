#pragma once
// Which files were read, and how each was then: by that a change is known without reading again.

#include "calc/base/file_reader.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace cli {

// Of a file or folder as it is found through links; all 0: there is none.
struct FileStamp {
  std::uint64_t size = 0, inode = 0;
  std::int64_t modified_ns = 0, changed_ns = 0;  // since 1970

  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::string& path);

using FileStamps = std::map<std::string, FileStamp>;  // by path, as it was asked for

// Those that are not as they were.
FileStamps changed_since(const FileStamps& stamps);

// Takes the stamp of each file before it is read for the first time, so that no change is lost.
class StampedReader : public calc::FileReader {
 public:
  explicit StampedReader(const calc::FileReader& reader) : reader_(reader) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override;
  // Of what is not read by this: a folder.
  void note(const std::string& path) const;
  FileStamps stamps() const;

 private:
  const calc::FileReader& reader_;
  mutable std::mutex mutex_;  // several projects are read at the same time
  mutable FileStamps stamps_;
};

}  // namespace cli
