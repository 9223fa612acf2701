#pragma once
// The choice of values in a row of a rule pack.

#include "calc/base/element_table.h"

#include <string>
#include <string_view>

namespace rules {

// The required values; the values "modified" by the context of the work; or the required values
// moved by steps on the standard's scale: up, or down if negative.
struct RowLevel {
  bool is_modified = false;
  int steps = 0;  // only without is_modified

  static const RowLevel required, modified;
  bool operator==(const RowLevel&) const = default;
};

inline constexpr RowLevel RowLevel::required{};
inline constexpr RowLevel RowLevel::modified{.is_modified = true};

// Returns "required", "modified", "-1", "+1" ..., as projects write them. At most 3 steps.
const calc::Names& level_names();
// Returns the level of one of these names; `required` for any other name.
RowLevel level_named(std::string_view name);
// Returns the name of a level of at most 3 steps.
std::string level_name(const RowLevel& level);

// Returns the words behind the row in reports: "" for required, "modified", "+1 step", "-2 steps".
std::string level_words(const RowLevel& level);

}  // namespace rules
