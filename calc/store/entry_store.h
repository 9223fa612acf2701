#pragma once
// Stores bytes by key: results that are computed once and used again.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// A key is a text with all that the bytes depend on: all writers of a key write the same bytes.
// Losing an entry costs time, never a result, so nothing here throws or stops a run.
class EntryStore {
 public:
  virtual ~EntryStore() = default;

  // Returns the bytes; empty if there is no usable entry. An entry of more than most_bytes is not
  // usable; no memory is taken for it.
  virtual std::optional<std::string> read(std::string_view key, std::size_t most_bytes) = 0;
  virtual void write(std::string_view key, std::string_view bytes) = 0;
  // Marks an entry as damaged: its bytes are intact, but their content is wrong.
  virtual void refuse(std::string_view key, std::string_view why) = 0;
};

}  // namespace calc
