#include "rules/catalogue/requirement.h"

namespace rules {

const char* comparison_name(Comparison comparison) {
  switch (comparison) {
    case Comparison::at_least:
      return "at-least";
    case Comparison::at_most:
      return "at-most";
    case Comparison::more_than:
      return "more-than";
    case Comparison::less_than:
      return "less-than";
  }
  return "";
}

bool is_in_lux(const Requirement& requirement) {
  return !is_ratio(requirement.metric) && !is_about_power(requirement.metric) &&
         !calc::is_plain_number(requirement.derived);
}

const char* unit_of(const Requirement& requirement) {
  if (is_about_power(requirement.metric)) return metric_unit(requirement.metric);
  return is_in_lux(requirement) ? "lx" : "";
}

}  // namespace rules
