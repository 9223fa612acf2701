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

// Sorted, since folders have no order of their own. None of a folder with too many: the first few
// would be any.
std::vector<std::string> names_in(const fs::path& folder) {
  constexpr std::size_t kMostNames = 10000;
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end;
       !error && at != end && names.size() < kMostNames; at.increment(error)) {
    names.push_back(at->path().filename().string());
  }
  if (names.size() == kMostNames) return {};
  std::sort(names.begin(), names.end());
  return names;
}

// "; did you mean 'lamp.ldt'?" of what is not there, "" where nothing in its folder is named alike.
std::string suggested_name(const fs::path& path) {
  std::vector<std::string> names =
      names_in(path.has_parent_path() ? path.parent_path() : fs::path("."));
  std::erase(names, path.filename().string());  // a link to nowhere is there itself
  return suggestion(path.filename().string(), {names.begin(), names.end()});
}

// The parts of a path, whichever slashes it is written with.
std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
    if (end > 0 && path.substr(0, end) != ".") parts.emplace_back(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return parts;
}

// The name of `part` in a folder: as it is written, else the first that differs in letter case
// only, else "".
std::string name_in_folder(const fs::path& folder, const std::string& part) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder / part, error))) return part;
  const std::string lowered = ascii_lowered(part);
  for (std::string& name : names_in(folder)) {
    if (ascii_lowered(name) == lowered) return std::move(name);
  }
  return {};
}

// The file that a path means but for letter case and backslashes: "lamps/a.ies" for
// "Lamps\A.ies", below `folder` where that is given; "" = there is none. may_show: whether names
// in a folder may be told.
template <class MayShow>
std::string same_but_for_spelling(const std::string& folder, std::string_view path,
                                  const MayShow& may_show) {
  if (!folder.empty() && path.starts_with(folder)) path.remove_prefix(folder.size());
  const bool is_absolute = folder.empty() && path.starts_with('/');
  fs::path at = is_absolute ? "/" : folder.empty() ? "." : folder;
  fs::path found = is_absolute ? "/" : "";
  for (const std::string& part : parts_of(path)) {
    const bool leads_up = part == "..";
    if ((leads_up && !folder.empty()) || !may_show(at)) return {};
    const std::string name = leads_up ? part : name_in_folder(at, part);
    if (name.empty()) return {};
    at /= name;
    found /= name;
  }
  std::error_code error;
  return may_show(at) && fs::is_regular_file(at, error) ? found.string() : std::string();
}

}  // namespace

FileContent DiskFileReader::read_within(const std::string& folder, const std::string& path) const {
  const OpenFile file(path);
  const int reason = errno;
  const bool is_open = file.number() >= 0;
  fs::path place = path;
  const auto is_allowed = [&](const fs::path& where) {
    const auto is_in = [&where](const std::string& one) { return lies_in(where, one); };
    return folder.empty() || is_in(folder) || std::any_of(allowed_.begin(), allowed_.end(), is_in);
  };
  if (!folder.empty()) {
    // Also of what is not there: a link must not tell what there is elsewhere.
    place = is_open ? real_place(file.number(), path) : real_path(path);
    if (place.empty() || !is_allowed(place)) {
      return {{}, "a symbolic link leads out of the folder '" + folder + "'", true};
    }
  }
  if (!is_open && reason == ENOENT) {
    const std::string same = same_but_for_spelling(
        folder, path, [&](const fs::path& where) { return is_allowed(real_path(where)); });
    const std::string hint = same.empty() ? suggested_name(place) : "; there is '" + same + "'";
    return failure(std::strerror(reason) + hint);
  }
  if (!is_open) return failure(std::strerror(reason));
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
