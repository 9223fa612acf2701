#include "rules/catalogue/requirement.h"

#include <algorithm>
#include <string_view>

namespace rules {

void add_note(const calc::Message& words, Requirement& requirement) {
  append(requirement.note, words);
}

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

const Requirement* area_of(const Requirement& glare, const std::vector<Requirement>& of_plane) {
  const auto area = std::find_if(of_plane.begin(), of_plane.end(), [&](const Requirement& other) {
    return other.metric == Metric::average && other.origin.pack == glare.origin.pack &&
           other.origin.row == glare.origin.row && other.origin.is_of_own_role;
  });
  return area == of_plane.end() ? nullptr : &*area;
}

const char* unit_of(const Requirement& requirement) {
  return has_unit_of_values(requirement.metric) ? calc::unit_of(requirement.derived)
                                                : metric_unit(requirement.metric);
}

const char* rating_of(const Requirement& requirement) {
  if (requirement.metric == Metric::glare_rating) return "GR";
  const bool is_of_observers =
      has_unit_of_values(requirement.metric) && requirement.derived == calc::DerivedQuantity::ugr;
  return is_of_observers || requirement.metric == Metric::ugr_table ? "UGR" : "";
}

bool is_in_lux(const Requirement& requirement) {
  return std::string_view(unit_of(requirement)) == "lx";
}

}  // namespace rules
