#include "calc/base/file_reader.h"

#include "calc/base/real_path.h"
#include "calc/base/text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace calc {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFileBytes = std::uintmax_t{512} << 20;

FileContent failure(std::string reason) { return {{}, std::move(reason)}; }

class OpenFile {
 public:
  // Never waits for who writes into a pipe, nor wakes a device.
  explicit OpenFile(const std::string& path)
      : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~OpenFile() {
    if (number_ >= 0) close(number_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

// Where what was opened really lies, whatever is done to its links meanwhile; without /proc, where
// its path leads now. "" = not known.
fs::path real_place(int file, const std::string& path) {
  std::error_code error;
  fs::path place = fs::read_symlink("/proc/self/fd/" + std::to_string(file), error);
  if (error) place = fs::canonical(path, error);
  return error ? fs::path() : place;
}

bool lies_in(const fs::path& place, const std::string& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) return false;
  return std::mismatch(real.begin(), real.end(), place.begin(), place.end()).first == real.end();
}

// "; did you mean 'lamp.ldt'?" of what is not there, "" where nothing in its folder is named alike.
std::string suggested_name(const fs::path& path) {
  constexpr std::size_t kMostNames = 10000;  // of more the first few would be any
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end;
       !error && at != end && names.size() < kMostNames; at.increment(error)) {
    if (at->path().filename() != path.filename())  // a link to nowhere is there itself
      names.push_back(at->path().filename().string());
  }
  if (names.size() == kMostNames) return {};
  std::sort(names.begin(), names.end());  // folders have no order of their own
  return suggestion(path.filename().string(), {names.begin(), names.end()});
}

}  // namespace

FileContent DiskFileReader::read_within(const std::string& folder, const std::string& path) const {
  const OpenFile file(path);
  const int reason = errno;
  const bool is_open = file.number() >= 0;
  fs::path place = path;
  if (!folder.empty()) {
    // Also of what is not there: a link must not tell what there is elsewhere.
    place = is_open ? real_place(file.number(), path) : real_path(path);
    const auto is_in = [&place](const std::string& one) { return lies_in(place, one); };
    if (place.empty() ||
        (!is_in(folder) && std::none_of(allowed_.begin(), allowed_.end(), is_in))) {
      return {{}, "a symbolic link leads out of the folder '" + folder + "'", true};
    }
  }
  if (!is_open) {
    return failure(std::strerror(reason) + (reason == ENOENT ? suggested_name(place) : ""));
  }
  struct stat status {};
  if (fstat(file.number(), &status) != 0) return failure(std::strerror(errno));
  if (S_ISDIR(status.st_mode)) return failure("it is a folder");
  if (!S_ISREG(status.st_mode)) return failure("it is not a regular file");
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > kLargestFileBytes) return failure("it is larger than 512 MiB");
  FileContent content;
  content.bytes.resize(size);
  std::size_t got = 0;
  while (got < content.bytes.size()) {
    const ssize_t now =
        ::read(file.number(), content.bytes.data() + got, content.bytes.size() - got);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) return failure(std::strerror(errno));
    if (now == 0) return failure("it became shorter while being read");
    got += static_cast<std::size_t>(now);
  }
  return content;
}

}  // namespace calc
