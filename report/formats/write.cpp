#include "report/formats/write.h"

#include <fcntl.h>
#include <unistd.h>

#include <sys/stat.h>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>

namespace report {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0666;  // less the umask

std::string reason(int error) { return std::generic_category().message(error); }

// Owns the descriptor of a file being written. Small pieces are written together.
class OpenFile : public Sink {
 public:
  OpenFile(const std::string& path, int flags) : descriptor_(::open(path.c_str(), flags, kMode)) {}
  ~OpenFile() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  bool is_open() const { return descriptor_ >= 0; }

  void write(std::string_view bytes) override {
    constexpr std::size_t kTogether = std::size_t{1} << 16;
    if (waiting_.size() + bytes.size() > kTogether) write_waiting();
    if (bytes.size() > kTogether) return write_now(bytes);
    waiting_ += bytes;
  }

  // Late errors (a full disk, a network file system) show up only here.
  void finish(bool flush) {
    write_waiting();
    std::string error;
    if (flush && ::fsync(descriptor_) != 0) error = reason(errno);
    if (::close(descriptor_) != 0 && error.empty()) error = reason(errno);
    descriptor_ = -1;
    if (!error.empty()) throw WriteFailure(error);
  }

 private:
  void write_waiting() {
    write_now(waiting_);
    waiting_.clear();
  }
  void write_now(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw WriteFailure(reason(errno));
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  int descriptor_;
  std::string waiting_;
};

using Make = std::function<void(Sink&)>;

void write_directly(const std::string& path, const Make& make) {
  OpenFile file(path, O_WRONLY | O_CLOEXEC);
  if (!file.is_open()) throw WriteFailure(reason(errno));
  make(file);
  file.finish(false);
}

fs::path temporary_name(const fs::path& target, int attempt) {
  const std::string name = "." + target.filename().string().substr(0, 100) + "." +
                           std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
  return target.parent_path() / name;
}

// A file beside the target, which is removed unless it takes the target's place.
class Temporary {
 public:
  // O_EXCL keeps writers apart: a name in use by another thread is left alone, and the next one
  // tried.
  explicit Temporary(const fs::path& target) {
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      path_ = temporary_name(target, attempt);
      file_.emplace(path_.string(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
      if (file_->is_open()) return;
      if (errno != EEXIST) throw WriteFailure(reason(errno));
    }
    throw WriteFailure("too many temporary files beside it");
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  OpenFile& file() { return *file_; }
  void replace(const fs::path& target) {
    fs::rename(path_, target);
    path_.clear();
  }

 private:
  fs::path path_;
  std::optional<OpenFile> file_;
};

void replace_file(const fs::path& target, const Make& make) {
  if (target.has_parent_path()) fs::create_directories(target.parent_path());
  Temporary temporary(target);
  make(temporary.file());
  temporary.file().finish(true);
  temporary.replace(target);
}

void write_whole(const std::string& path, const Make& make) {
  fs::path target = path;
  if (!target.has_filename()) throw WriteFailure("this is a folder");
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) throw WriteFailure("this is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_directly(path, make);
  if (fs::is_symlink(fs::symlink_status(target, ignored))) target = fs::weakly_canonical(target);
  replace_file(target, make);
}

}  // namespace

std::string write_file_atomically(const std::string& path, std::string_view bytes) {
  return write_file_atomically(path, [bytes](Sink& sink) { sink.write(bytes); });
}

std::string write_file_atomically(const std::string& path, const std::function<void(Sink&)>& make) {
  if (path.empty()) return "the file name is empty";
  try {
    write_whole(path, make);
    return {};
  } catch (const WriteFailure& failure) {
    return failure.what();
  } catch (const fs::filesystem_error& error) {
    return error.code().message();
  }
}

}  // namespace report
