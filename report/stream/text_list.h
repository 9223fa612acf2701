#pragma once
// Texts that wait in a spill, one behind the other.

#include "report/stream/spill.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace report {

// Each behind its length, so that it may hold anything.
class TextList {
 public:
  explicit TextList(const SpillPlace& place) : spill_(place) {}

  void add(std::string_view text);

 private:
  friend class TextListReader;
  Spill spill_;
};

// In the order that they were added. The list stays as it is meanwhile.
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
