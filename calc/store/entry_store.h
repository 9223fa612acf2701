#pragma once
// Bytes by key: what is computed once and used again.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// A key is a text that says all that the bytes depend on: whoever writes one key writes the same
// bytes. Losing an entry costs time, never a result, so nothing here throws or stops a run.
class EntryStore {
 public:
  virtual ~EntryStore() = default;

  // Empty: there is no such entry, or none that can be used. An entry of more than most_bytes is
  // none that can be used; no memory is taken for it.
  virtual std::optional<std::string> read(std::string_view key, std::size_t most_bytes) = 0;
  virtual void write(std::string_view key, std::string_view bytes) = 0;
  // Of an entry whose bytes are well kept but do not say what they must: it counts as damaged.
  virtual void refuse(std::string_view key, std::string_view why) = 0;
};

}  // namespace calc
