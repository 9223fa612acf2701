#include "calc/store/folder_care.h"

#include "calc/store/entry_file.h"
#include "calc/store/file_descriptor.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace calc {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLeftBehindAfter_s = 24 * 60 * 60;
// No entry is larger; what is, was not written by us.
constexpr std::uintmax_t kMostFileBytes = std::uintmax_t{1} << 32;

struct Found {
  std::string place;  // "ab/cdef..."
  std::uint64_t bytes = 0;
  std::int64_t used_s = 0;
};

struct Listing {
  std::vector<Found> entries, left_behind;
  std::string problem;
};

bool is_hex(std::string_view name, std::size_t digits) {
  return name.size() == digits &&
         name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

void list_part(const fs::path& part, Listing& listing) {
  std::error_code failure;
  for (fs::directory_iterator it(part, failure), end; !failure && it != end;
       it.increment(failure)) {
    const std::string name = it->path().filename().string();
    const bool is_left_behind = name.starts_with(kTemporaryPrefix);
    if (!is_left_behind && !is_hex(name, 62)) continue;
    struct stat state {};
    if (lstat(it->path().c_str(), &state) != 0) continue;  // deleted meanwhile
    (is_left_behind ? listing.left_behind : listing.entries)
        .push_back({part.filename().string() + "/" + name,
                    S_ISREG(state.st_mode) ? static_cast<std::uint64_t>(state.st_size) : 0,
                    static_cast<std::int64_t>(state.st_mtime)});
  }
}

Listing list_store(const std::string& folder) {
  Listing listing;
  std::error_code failure;
  fs::directory_iterator it(folder, failure);
  for (const fs::directory_iterator end; !failure && it != end; it.increment(failure)) {
    if (is_hex(it->path().filename().string(), 2) &&
        it->symlink_status().type() == fs::file_type::directory) {
      list_part(it->path(), listing);
    }
  }
  if (failure) listing.problem = failure.message();
  return listing;
}

StoreCount count_of(const Listing& listing) {
  StoreCount count;
  count.problem = listing.problem;
  count.left_behind = listing.left_behind.size();
  for (const Found& entry : listing.entries) {
    count.oldest_use_s =
        count.entries == 0 ? entry.used_s : std::min(count.oldest_use_s, entry.used_s);
    count.newest_use_s = std::max(count.newest_use_s, entry.used_s);
    ++count.entries;
    count.bytes += entry.bytes;
  }
  return count;
}

// "" or what is wrong; `bytes` is the file.
std::string read_file(const std::string& path, std::size_t most_bytes, std::string& bytes) {
  const FileDescriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) {
    return errno == ELOOP ? "it is a link" : std::generic_category().message(errno);
  }
  struct stat state {};
  if (fstat(file.number(), &state) != 0) return std::generic_category().message(errno);
  if (!S_ISREG(state.st_mode)) return "it is not a file";
  const auto size = static_cast<std::uintmax_t>(state.st_size);
  if (size > kMostFileBytes) return fmt::format("its size of {} bytes is too large", size);
  bytes.resize(std::min<std::size_t>(size, most_bytes));
  return file.read(bytes.data(), bytes.size()) == bytes.size() ? ""
                                                               : "it cannot be read completely";
}

std::string problem_with_entry(const std::string& folder, const Found& found) {
  std::string bytes;
  std::string problem = read_file(folder + "/" + found.place, kMostFileBytes, bytes);
  if (!problem.empty()) return problem;
  const ParsedEntry entry = parse_entry(bytes);
  if (!entry.problem.empty()) return entry.problem;
  const EntryPlace place = place_of_key(entry.key);
  return place.folder + "/" + place.file == found.place ? "" : "it has another key";
}

// Damaged ones, too: all that was an entry once, but nothing that another program wrote.
bool may_be_deleted(const std::string& path) {
  std::string head;
  return read_file(path, 8, head).empty() && (head.empty() || begins_as_entry(head));
}

}  // namespace

StoreCount count_entries(const std::string& folder) { return count_of(list_store(folder)); }

StoreCount verify_entries(
    const std::string& folder,
    const std::function<void(const std::string& place, const std::string& why)>& on_damage) {
  Listing listing = list_store(folder);
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const Found& a, const Found& b) { return a.place < b.place; });
  for (const Found& entry : listing.entries) {
    const std::string problem = problem_with_entry(folder, entry);
    if (!problem.empty()) on_damage(entry.place, problem);
  }
  return count_of(listing);
}

PruneResult prune_entries(const std::string& folder, std::uint64_t most_bytes, std::int64_t now_s) {
  PruneResult result;
  Listing listing = list_store(folder);
  result.problem = listing.problem;
  std::vector<Found> kept_behind;
  for (const Found& file : listing.left_behind) {
    if (now_s - file.used_s >= kLeftBehindAfter_s &&
        unlink((folder + "/" + file.place).c_str()) == 0) {
      ++result.deleted_left_behind;
    } else {
      kept_behind.push_back(file);
    }
  }
  listing.left_behind = std::move(kept_behind);
  // Newest first; of one time by name, so that the same store is pruned the same way.
  std::sort(listing.entries.begin(), listing.entries.end(), [](const Found& a, const Found& b) {
    return std::tie(b.used_s, a.place) < std::tie(a.used_s, b.place);
  });
  std::vector<Found> kept;
  std::uint64_t kept_bytes = 0;
  bool is_full = false;  // what was used before the first that has no room goes, however small
  for (const Found& entry : listing.entries) {
    const std::string path = folder + "/" + entry.place;
    is_full = is_full || entry.bytes > most_bytes - kept_bytes;
    if (!is_full) {
      kept_bytes += entry.bytes;
      kept.push_back(entry);
    } else if (may_be_deleted(path) && unlink(path.c_str()) == 0) {
      ++result.deleted_entries;
      result.deleted_bytes += entry.bytes;
    } else {
      kept.push_back(entry);
      if (result.problem.empty()) {
        result.problem = fmt::format("'{}' could not be deleted", entry.place);
      }
    }
  }
  listing.entries = std::move(kept);
  result.kept = count_of(listing);
  result.kept.problem.clear();
  return result;
}

}  // namespace calc
