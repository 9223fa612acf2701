#include "report/formats/write.h"

#include <fcntl.h>
#include <unistd.h>

#include <sys/stat.h>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace report {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0666;  // less the umask

std::string reason(int error) { return std::generic_category().message(error); }

// Owns the descriptor of a file being written.
class OpenFile {
 public:
  OpenFile(const std::string& path, int flags) : descriptor_(::open(path.c_str(), flags, kMode)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  bool is_open() const { return descriptor_ >= 0; }

  std::string write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return reason(errno);
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
  }

  // Late errors (a full disk, a network file system) show up only here.
  std::string finish(bool flush) {
    std::string error;
    if (flush && ::fsync(descriptor_) != 0) error = reason(errno);
    if (::close(descriptor_) != 0 && error.empty()) error = reason(errno);
    descriptor_ = -1;
    return error;
  }

 private:
  int descriptor_;
};

std::string write_directly(const std::string& path, std::string_view bytes) {
  OpenFile file(path, O_WRONLY | O_CLOEXEC);
  if (!file.is_open()) return reason(errno);
  const std::string error = file.write(bytes);
  return error.empty() ? file.finish(false) : error;
}

fs::path temporary_name(const fs::path& target, int attempt) {
  const std::string name = "." + target.filename().string().substr(0, 100) + "." +
                           std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
  return target.parent_path() / name;
}

struct Temporary {
  fs::path path;
  std::string error;
};

// O_EXCL keeps writers apart: a name in use by another thread is left alone, and the next one
// tried.
Temporary write_temporary(const fs::path& target, std::string_view bytes) {
  constexpr int kAttempts = 1000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const fs::path path = temporary_name(target, attempt);
    OpenFile file(path.string(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
    if (!file.is_open() && errno == EEXIST) continue;
    if (!file.is_open()) return {path, reason(errno)};
    std::string error = file.write(bytes);
    if (error.empty()) error = file.finish(true);
    if (!error.empty()) ::unlink(path.c_str());
    return {path, error};
  }
  return {target, "too many temporary files beside it"};
}

std::string replace_file(const fs::path& target, std::string_view bytes) {
  std::error_code failure;
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), failure);
  if (failure) return failure.message();
  const Temporary temporary = write_temporary(target, bytes);
  if (!temporary.error.empty()) return temporary.error;
  fs::rename(temporary.path, target, failure);
  if (!failure) return {};
  ::unlink(temporary.path.c_str());
  return failure.message();
}

}  // namespace

std::string write_file_atomically(const std::string& path, std::string_view bytes) {
  if (path.empty()) return "the file name is empty";
  try {
    std::error_code failure;
    fs::path target = path;
    if (!target.has_filename()) return "this is a folder";
    const fs::file_status status = fs::status(target, failure);
    if (fs::is_directory(status)) return "this is a folder";
    if (fs::exists(status) && !fs::is_regular_file(status)) return write_directly(path, bytes);
    if (fs::is_symlink(fs::symlink_status(target, failure))) {
      target = fs::weakly_canonical(target, failure);
      if (failure) return failure.message();
    }
    return replace_file(target, bytes);
  } catch (const fs::filesystem_error& error) {
    return error.code().message();
  }
}

}  // namespace report
