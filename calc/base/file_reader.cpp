#include "calc/base/file_reader.h"

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
#include <system_error>
#include <utility>

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

}  // namespace

FileContent DiskFileReader::read_within(const std::string& folder, const std::string& path) const {
  const OpenFile file(path);
  const int error = file.number() < 0 ? errno : 0;
  // Of what a sandbox or the system does not open, too: a link that leads out is told as one.
  if (!folder.empty() && (error == 0 || error == EACCES)) {
    const fs::path place = real_place(file.number(), path);
    if (place.empty() && error != 0) return failure(std::strerror(error));
    const auto is_in = [&place](const std::string& one) { return lies_in(place, one); };
    if (place.empty() ||
        (!is_in(folder) && std::none_of(allowed_.begin(), allowed_.end(), is_in))) {
      return {{}, "a symbolic link leads out of the folder '" + folder + "'", true};
    }
  }
  if (error != 0) return failure(std::strerror(error));
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
