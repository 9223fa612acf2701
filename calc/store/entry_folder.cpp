#include "calc/store/entry_folder.h"

#include "calc/store/entry_file.h"
#include "calc/store/file_descriptor.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <random>
#include <system_error>

namespace calc {
namespace {

namespace fs = std::filesystem;

// The first line is a standard's, by which backup programs know caches.
constexpr std::string_view kMarkText =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# This folder is a store of luxgate (check --store): looks of planes, to be used again.\n"
    "# It may be deleted at any time; what is missing is calculated again.\n";

// An entry's time tells when it was last used; not written at every use.
constexpr std::time_t kUseIsNotedEvery_s = 24 * 60 * 60;

std::string words_of(int error) { return std::generic_category().message(error); }

bool is_marked(const fs::path& folder) {
  const FileDescriptor file(open((folder / kStoreMark).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  std::string text(kMarkText.size(), '\0');
  return file.is_open() && file.read(text.data(), text.size()) == text.size() && text == kMarkText;
}

void note_use(const FileDescriptor& file, const struct stat& state) {
  if (std::time(nullptr) - state.st_mtime < kUseIsNotedEvery_s) return;
  const timespec times[2] = {{0, UTIME_OMIT}, {0, UTIME_NOW}};
  static_cast<void>(futimens(file.number(), times));  // a store of others is only read
}

// Different at each call, in every process and on every machine.
std::string temporary_name() {
  std::random_device random;
  return fmt::format("{}{:08x}{:08x}", kTemporaryPrefix, random(), random());
}

// The whole file under a temporary name, then renamed to `name`. "" or what failed.
std::string put_file(const FileDescriptor& folder, const std::string& name,
                     std::string_view bytes) {
  const std::string temporary = temporary_name();
  {
    FileDescriptor file(
        openat(folder.number(), temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.is_open()) return words_of(errno);
    if (!file.write(bytes)) {
      const int error = errno;
      unlinkat(folder.number(), temporary.c_str(), 0);
      return words_of(error);
    }
  }
  const auto has_moved = [&] {
    return renameat(folder.number(), temporary.c_str(), folder.number(), name.c_str()) == 0;
  };
  if (has_moved()) return "";
  int error = errno;
  // A folder in the entry's place gives way if it is empty.
  if (error == EISDIR && unlinkat(folder.number(), name.c_str(), AT_REMOVEDIR) == 0) {
    if (has_moved()) return "";
    error = errno;
  }
  unlinkat(folder.number(), temporary.c_str(), 0);
  return words_of(error);
}

// Makes the folder and its mark. "" or what failed.
std::string make_store(const std::string& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return failure.message();
  if (is_marked(folder)) return "";
  const FileDescriptor store(open_folder(AT_FDCWD, folder, true));
  return store.is_open() ? put_file(store, kStoreMark, kMarkText) : words_of(errno);
}

}  // namespace

std::string problem_with_store(const std::string& folder) {
  std::error_code failure;
  const fs::file_status state = fs::status(folder, failure);
  if (state.type() == fs::file_type::not_found) return "";
  if (!fs::is_directory(state)) {
    return fmt::format("'{}' is not a folder; a store is a folder, or a path where one can be made",
                       folder);
  }
  if (is_marked(folder)) return "";
  // Another process may be making it at this moment. One that cannot be read is told of when it is
  // used.
  bool is_empty = true;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    is_empty = is_empty && it->path().filename().string().starts_with(kTemporaryPrefix);
  }
  return is_empty || is_marked(folder)
             ? ""
             : fmt::format(
                   "'{}' is not a store: it has files, but no {} of luxgate; allowed are a store, "
                   "an empty folder or a new path",
                   folder, kStoreMark);
}

std::optional<std::string> EntryFolder::read(std::string_view key, std::size_t most_bytes) {
  const EntryPlace place = place_of_key(key);
  const std::string name = place.folder + "/" + place.file;
  const auto unusable = [&](std::string_view why) {
    note_unusable(name, why);
    return std::nullopt;
  };
  const FileDescriptor store(open_folder(AT_FDCWD, folder_, true));
  if (!store.is_open()) return std::nullopt;
  const FileDescriptor folder(open_folder(store.number(), place.folder, false));
  if (!folder.is_open()) {
    return errno == ENOENT ? std::nullopt : unusable(words_of(errno));
  }
  // Neither through a link nor waiting for a pipe.
  const FileDescriptor file(
      openat(folder.number(), place.file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) {
    if (errno == ENOENT) return std::nullopt;
    return unusable(errno == ELOOP ? "it is a link" : words_of(errno));
  }
  struct stat state {};
  if (fstat(file.number(), &state) != 0) return unusable(words_of(errno));
  if (!S_ISREG(state.st_mode)) return unusable("it is not a file");
  const auto size = static_cast<std::size_t>(state.st_size);
  if (size > entry_file_bytes(key.size(), most_bytes)) {
    return unusable(fmt::format("its size of {} bytes is too large", size));
  }
  std::string bytes(size, '\0');
  if (file.read(bytes.data(), size) != size) return unusable("it cannot be read completely");
  const ParsedEntry entry = parse_entry(bytes);
  if (!entry.problem.empty()) return unusable(entry.problem);
  if (entry.key != key) return unusable("it has another key");
  note_use(file, state);
  return std::string(entry.bytes);
}

void EntryFolder::write(std::string_view key, std::string_view bytes) {
  {
    const std::scoped_lock lock(mutex_);
    if (!is_marked_) {
      if (const std::string failure = make_store(folder_); !failure.empty()) {
        if (troubles_.not_written.empty()) troubles_.not_written = failure;
        return;
      }
      is_marked_ = true;
    }
  }
  const EntryPlace place = place_of_key(key);
  const FileDescriptor store(open_folder(AT_FDCWD, folder_, true));
  if (!store.is_open()) return note_not_written(words_of(errno));
  if (mkdirat(store.number(), place.folder.c_str(), 0777) != 0 && errno != EEXIST) {
    return note_not_written(words_of(errno));
  }
  const FileDescriptor folder(open_folder(store.number(), place.folder, false));
  if (!folder.is_open()) return note_not_written(words_of(errno));
  const std::string failure = put_file(folder, place.file, render_entry(key, bytes));
  if (!failure.empty()) note_not_written(failure);
}

void EntryFolder::refuse(std::string_view key, std::string_view why) {
  const EntryPlace place = place_of_key(key);
  note_unusable(place.folder + "/" + place.file, why);
}

StoreTroubles EntryFolder::troubles() const {
  const std::scoped_lock lock(mutex_);
  return troubles_;
}

void EntryFolder::note_unusable(const std::string& place, std::string_view why) {
  const std::scoped_lock lock(mutex_);
  if (troubles_.unusable++ == 0) troubles_.unusable_why = fmt::format("'{}': {}", place, why);
}

void EntryFolder::note_not_written(const std::string& why) {
  const std::scoped_lock lock(mutex_);
  if (troubles_.not_written.empty()) troubles_.not_written = why;
}

}  // namespace calc
