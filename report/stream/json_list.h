#pragma once
// A list in a JSON file that is filled item by item.

#include "report/stream/spill.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>

namespace report {

// Writes a list as json_layout() would. All members throw WriteFailure.
class JsonList {
 public:
  // depth: number of lists and objects around it.
  JsonList(const SpillPlace& place, std::size_t depth) : items_(place), depth_(depth) {}

  void add(const nlohmann::ordered_json& item);  // an object
  // Copies the list. more: a list of the same depth whose items follow.
  void copy_to(Sink& sink, const JsonList* more = nullptr) const;

 private:
  Spill items_;
  std::size_t depth_;
};

}  // namespace report
