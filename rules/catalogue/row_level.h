#pragma once
// Which values of a row of a rule pack count.

#include "calc/base/element_table.h"

#include <string>
#include <string_view>

namespace rules {

// What the row requires; its values "modified" by the context of the work; or what it requires, so
// many steps of the standard's scale away: up, or down if negative.
struct RowLevel {
  bool is_modified = false;
  int steps = 0;  // only without is_modified

  static const RowLevel required, modified;
  bool operator==(const RowLevel&) const = default;
};

inline constexpr RowLevel RowLevel::required{};
inline constexpr RowLevel RowLevel::modified{.is_modified = true};

// "required", "modified", "-1", "+1" ...: as projects write them. At most 3 steps.
const calc::Names& level_names();
// Of one of these names; `required` of any other.
RowLevel level_named(std::string_view name);
// At most 3 steps.
std::string level_name(const RowLevel& level);

// As reports say it behind the row: "" of required, "modified", "+1 step", "-2 steps".
std::string level_words(const RowLevel& level);

}  // namespace rules
