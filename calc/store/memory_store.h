#pragma once
// A store for one run: in memory, and gone with it.

#include "calc/store/entry_store.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace calc {

// Any number of threads may use it at once. What would make it larger than most_bytes is not kept.
class MemoryStore : public EntryStore {
 public:
  explicit MemoryStore(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  std::optional<std::string> read(std::string_view key, std::size_t most_bytes) override;
  void write(std::string_view key, std::string_view bytes) override;
  // Forgets it: whoever refuses it writes another.
  void refuse(std::string_view key, std::string_view why) override;

  // Forgets all if it holds more than that: for programs that run on and on.
  void clear_above(std::size_t bytes);

 private:
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::mutex mutex_;
  std::map<std::string, std::string> entries_;  // by hashes of keys, which may be long
};

}  // namespace calc
