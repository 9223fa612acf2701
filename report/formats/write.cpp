#include "report/formats/write.h"

#include "calc/base/real_path.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <sys/stat.h>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace report {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0666;  // less the umask

std::string reason(int error) { return std::generic_category().message(error); }

// Owns the descriptor of a file being written. Small pieces are written together.
class OpenFile : public Sink {
 public:
  OpenFile(const std::string& path, int flags) : descriptor_(::open(path.c_str(), flags, kMode)) {}
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  bool is_open() const { return descriptor_ >= 0; }
  // Another descriptor of it: as long as that is open nobody takes the file for one that was left
  // behind.
  int lock() const {
    ::flock(descriptor_, LOCK_EX | LOCK_NB);
    return ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  }

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

// A pipe is opened once somebody reads from it, for whom is waited a little.
int open_directly(const std::string& path) {
  constexpr int kTries = 100;
  constexpr std::chrono::milliseconds kPause{100};
  for (int i = 0; i < kTries; ++i) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor >= 0) {
      ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
      return descriptor;
    }
    if (errno != ENXIO) throw WriteFailure(reason(errno));
    std::this_thread::sleep_for(kPause);
  }
  throw WriteFailure("nobody reads from this pipe");
}

void write_directly(const std::string& path, const Make& make) {
  OpenFile file(open_directly(path));
  make(file);
  file.finish(false);
}

std::string temporary_prefix(const fs::path& target) {
  return "." + target.filename().string().substr(0, 100) + ".";
}
constexpr std::string_view kTemporarySuffix = ".tmp";

fs::path temporary_name(const fs::path& target, int attempt) {
  return target.parent_path() / (temporary_prefix(target) + std::to_string(::getpid()) + "-" +
                                 std::to_string(attempt) + std::string(kTemporarySuffix));
}

// Whether it is ".<target>.<digits>-<digits>.tmp".
bool is_temporary_of(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(kTemporarySuffix)) return false;
  if (name.size() < prefix.size() + kTemporarySuffix.size()) return false;
  name.remove_prefix(prefix.size());
  name.remove_suffix(kTemporarySuffix.size());
  return name.find('-') != std::string_view::npos &&
         name.find_first_not_of("0123456789-") == std::string_view::npos;
}

// What a killed run has left for this target. Whoever writes holds a lock on the file, but for a
// moment at its beginning.
void remove_left_behind(const fs::path& target) {
  constexpr std::chrono::minutes kMoment{1};
  const std::string prefix = temporary_prefix(target);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code error;
  std::vector<fs::path> left;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (!is_temporary_of(entry->path().filename().string(), prefix)) continue;
    if (!fs::is_regular_file(entry->symlink_status(ignored))) continue;
    const auto age = fs::file_time_type::clock::now() - entry->last_write_time(ignored);
    if (!ignored && age > kMoment) left.push_back(entry->path());
  }
  for (const fs::path& path : left) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
    ::close(descriptor);
  }
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
      if (file_->is_open()) {
        lock_ = file_->lock();
        return;
      }
      if (errno != EEXIST) throw WriteFailure(reason(errno));
    }
    throw WriteFailure("too many temporary files beside it");
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
    if (lock_ >= 0) ::close(lock_);
  }

  OpenFile& file() { return *file_; }
  void replace(const fs::path& target) {
    fs::rename(path_, target);
    path_.clear();
  }

 private:
  fs::path path_;
  std::optional<OpenFile> file_;
  int lock_ = -1;
};

}  // namespace

// A file that is whole, but for its place.
class WaitingFile {
 public:
  explicit WaitingFile(std::string path) : path_(std::move(path)) {}
  WaitingFile(const WaitingFile&) = delete;
  WaitingFile& operator=(const WaitingFile&) = delete;
  virtual ~WaitingFile() = default;

  virtual void take_place() = 0;
  const std::string& path() const { return path_; }  // as it was named

 private:
  std::string path_;
};

namespace {

class FileBeside : public WaitingFile {
 public:
  FileBeside(std::string path, fs::path target, const Make& make)
      : WaitingFile(std::move(path)), target_(std::move(target)), temporary_(target_) {
    make(temporary_.file());
    temporary_.file().finish(true);
  }

  void take_place() override { temporary_.replace(target_); }

 private:
  fs::path target_;
  Temporary temporary_;
};

// What is to be renamed; empty: it is written already, into a device or a pipe.
std::unique_ptr<WaitingFile> write_beside(const std::string& path, const Make& make) {
  fs::path target = path;
  if (!target.has_filename()) throw WriteFailure("this is a folder");
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) throw WriteFailure("this is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_directly(path, make);
    return nullptr;
  }
  if (fs::is_symlink(fs::symlink_status(target, ignored))) target = calc::real_path(target);
  if (target.has_parent_path()) fs::create_directories(target.parent_path());
  remove_left_behind(target);
  return std::make_unique<FileBeside>(path, target, make);
}

// "" or the reason; what else `work` throws goes on.
std::string reason_of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const WriteFailure& failure) {
    return failure.what();
  } catch (const fs::filesystem_error& error) {
    return error.code().message();
  }
}

}  // namespace

FileSet::FileSet() = default;
FileSet::~FileSet() = default;

std::string FileSet::add(const std::string& path, const std::function<void(Sink&)>& make) {
  if (path.empty()) return "the file name is empty";
  return reason_of([&] {
    if (auto whole = write_beside(path, make)) waiting_.push_back(std::move(whole));
  });
}

std::vector<std::string> FileSet::publish(std::vector<std::string>& published) {
  std::vector<std::string> problems;
  for (const std::unique_ptr<WaitingFile>& file : waiting_) {
    const std::string problem = reason_of([&] { file->take_place(); });
    if (problem.empty()) {
      published.push_back(file->path());
    } else {
      problems.push_back(fmt::format("cannot write '{}': {}", file->path(), problem));
    }
  }
  waiting_.clear();
  return problems;
}

std::string write_file_atomically(const std::string& path, std::string_view bytes) {
  return write_file_atomically(path, [bytes](Sink& sink) { sink.write(bytes); });
}

std::string write_file_atomically(const std::string& path, const std::function<void(Sink&)>& make) {
  if (path.empty()) return "the file name is empty";
  return reason_of([&] {
    if (const auto whole = write_beside(path, make)) {
      whole->take_place();
    }
  });
}

}  // namespace report
