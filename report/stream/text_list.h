#pragma once
// Texts in a spill, one behind the other.

#include "report/stream/spill.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace report {

// Stores each text behind its length, so that it may contain anything.
class TextList {
 public:
  explicit TextList(const SpillPlace& place) : spill_(place) {}

  void add(std::string_view text);

 private:
  friend class TextListReader;
  Spill spill_;
};

// Reads the texts in the order in which they were added. The list must not change meanwhile.
class TextListReader {
 public:
  explicit TextListReader(const TextList& list) : spill_(list.spill_) {}

  bool is_at_end() const { return at_ == spill_.size(); }
  std::string next();

 private:
  std::string take(std::size_t count);

  const Spill& spill_;
  std::uint64_t at_ = 0;
  std::string ahead_;  // what was read from there on, less what was taken
  std::size_t taken_ = 0;
};

}  // namespace report
