#include "rules/catalogue/requirement.h"

#include <string_view>

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

const char* unit_of(const Requirement& requirement) {
  return has_unit_of_values(requirement.metric) ? calc::unit_of(requirement.derived)
                                                : metric_unit(requirement.metric);
}

bool is_in_lux(const Requirement& requirement) {
  return std::string_view(unit_of(requirement)) == "lx";
}

}  // namespace rules
