#pragma once
// Lists a store's folder, finds damaged entries, and makes room. It deletes only files that are
// named and begin like entries.

#include <cstdint>
#include <functional>
#include <string>

namespace calc {

struct StoreCount {
  std::uint64_t entries = 0, bytes = 0;
  std::int64_t oldest_use_s = 0, newest_use_s = 0;  // since 1970; 0 = there is no entry
  std::uint64_t left_behind = 0;                    // files of writers that were killed
  std::string problem;                              // why the folder could not be read; "" = it was
};
StoreCount count_entries(const std::string& folder);

// Reads every entry whole: format, checksum, and whether its key leads to its place. Calls
// on_damage with the place and the fault.
StoreCount verify_entries(
    const std::string& folder,
    const std::function<void(const std::string& place, const std::string& why)>& on_damage);

struct PruneResult {
  StoreCount kept;
  std::uint64_t deleted_entries = 0, deleted_bytes = 0;
  std::uint64_t deleted_left_behind = 0;
  std::string problem;  // of the first that could not be deleted, or why nothing was read
};
// Deletes entries, the least recently used first, until the rest has at most most_bytes; and files
// that killed writers left behind a day ago or more. now_s: since 1970.
PruneResult prune_entries(const std::string& folder, std::uint64_t most_bytes, std::int64_t now_s);

}  // namespace calc
