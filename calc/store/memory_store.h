#pragma once
// A store for a single run, in memory.

#include "calc/store/entry_store.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace calc {

// Any number of threads may use it at once. Entries that would exceed most_bytes are not kept.
class MemoryStore : public EntryStore {
 public:
  explicit MemoryStore(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  std::optional<std::string> read(std::string_view key, std::size_t most_bytes) override;
  void write(std::string_view key, std::string_view bytes) override;
  // Removes the entry, because the caller then writes another.
  void refuse(std::string_view key, std::string_view why) override;

  // Removes all entries if it holds more than that: for long-running programs.
  void clear_above(std::size_t bytes);

 private:
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::mutex mutex_;
  std::map<std::string, std::string> entries_;  // by hashes of keys, which may be long
};

}  // namespace calc
