#pragma once
// A list in a JSON file that is filled item by item.

#include "report/stream/spill.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>

namespace report {

// As json_layout() would have it. All members throw WriteFailure.
class JsonList {
 public:
  // depth: how many lists and objects it stands in.
  JsonList(const SpillPlace& place, std::size_t depth) : items_(place), depth_(depth) {}

  void add(const nlohmann::ordered_json& item);  // an object
  // more: its items are behind the others; of the same depth.
  void copy_to(Sink& sink, const JsonList* more = nullptr) const;

 private:
  Spill items_;
  std::size_t depth_;
};

}  // namespace report
