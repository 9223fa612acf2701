#pragma once
// A store in a folder: <folder>/ab/cdef..., one file per entry. Nothing is locked: files appear
// whole, by renaming, and two writers of a key write the same bytes.

#include "calc/store/entry_store.h"

#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace calc {

// This file marks a folder as a store, and for backup programs as a cache.
inline constexpr const char* kStoreMark = "CACHEDIR.TAG";

// Returns "" if the folder is a store, or can become one: it is empty, or does not exist. Else the
// problem, and what is allowed.
std::string problem_with_store(const std::string& folder);

// Problems during a run. Each text is about the first of its kind.
struct StoreTroubles {
  std::uint64_t unusable = 0;  // entries that were there and could not be used
  std::string unusable_why;    // "'ab/cd...': its checksum is wrong"
  std::string not_written;     // why an entry could not be written; "" = all were
};

// Any number of threads and processes may use one folder at once. The first entry written creates
// it.
class EntryFolder : public EntryStore {
 public:
  explicit EntryFolder(std::string folder) : folder_(std::move(folder)) {}

  std::optional<std::string> read(std::string_view key, std::size_t most_bytes) override;
  void write(std::string_view key, std::string_view bytes) override;
  void refuse(std::string_view key, std::string_view why) override;

  StoreTroubles troubles() const;

 private:
  void note_unusable(const std::string& place, std::string_view why);
  void note_not_written(const std::string& why);

  std::string folder_;
  mutable std::mutex mutex_;
  StoreTroubles troubles_;
  bool is_marked_ = false;
};

}  // namespace calc
