#include "rules/catalogue/row_level.h"

#include <fmt/format.h>

#include <algorithm>

namespace rules {

const calc::Names& level_names() {
  static const calc::Names kNames{"required", "modified", "-3", "-2", "-1", "+1", "+2", "+3"};
  return kNames;
}

RowLevel level_named(std::string_view name) {
  const calc::Names& names = level_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) return RowLevel::required;
  if (name == "required") return RowLevel::required;
  if (name == "modified") return RowLevel::modified;
  const int steps = name.at(1) - '0';
  return {.steps = name.front() == '-' ? -steps : steps};
}

std::string level_name(const RowLevel& level) {
  if (level.is_modified) return "modified";
  return level.steps == 0 ? "required" : fmt::format("{:+}", level.steps);
}

std::string level_words(const RowLevel& level) {
  if (level.is_modified) return "modified";
  if (level.steps == 0) return {};
  const bool is_one = level.steps == 1 || level.steps == -1;
  return fmt::format("{:+} step{}", level.steps, is_one ? "" : "s");
}

}  // namespace rules
