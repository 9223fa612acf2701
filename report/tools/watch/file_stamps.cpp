#include "report/tools/watch/file_stamps.h"

#include <sys/stat.h>

namespace cli {
namespace {

std::int64_t nanoseconds(const timespec& time) {
  constexpr std::int64_t kPerSecond = 1'000'000'000;
  return static_cast<std::int64_t>(time.tv_sec) * kPerSecond + time.tv_nsec;
}

}  // namespace

FileStamp stamp_of(const std::string& path) {
  struct stat state {};
  if (stat(path.c_str(), &state) != 0) return {};
  return {static_cast<std::uint64_t>(state.st_size), state.st_ino, nanoseconds(state.st_mtim),
          nanoseconds(state.st_ctim)};
}

FileStamps changed_since(const FileStamps& stamps) {
  FileStamps changed;
  for (const auto& [path, stamp] : stamps) {
    const FileStamp now = stamp_of(path);
    if (now != stamp) changed.emplace(path, now);
  }
  return changed;
}

calc::FileContent StampedReader::read_within(const std::string& folder,
                                             const std::string& path) const {
  note(path);
  return reader_.read_within(folder, path);
}

void StampedReader::note(const std::string& path) const {
  const std::scoped_lock lock(mutex_);
  stamps_.emplace(path, stamp_of(path));
}

FileStamps StampedReader::stamps() const {
  const std::scoped_lock lock(mutex_);
  return stamps_;
}

}  // namespace cli
