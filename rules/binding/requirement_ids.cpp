#include "rules/binding/requirement_ids.h"

#include "calc/base/diagnostic_ids.h"

#include <fmt/format.h>

namespace rules {

RequirementIds::RequirementIds(const std::vector<calc::RequirementText>& texts,
                               calc::Diagnostics& diagnostics) {
  for (const calc::RequirementText& text : texts) {
    if (!text.role.empty()) continue;  // a workplace, whose id is another one
    const calc::XmlAttribute* id = text.element.find("id");
    if (id == nullptr || id->value.empty()) continue;  // an empty id is reported where it is read
    const auto [first, is_new] = line_of_given_.emplace(id->value, id->where.line);
    if (is_new) continue;
    diagnostics.report(calc::DiagnosticId::duplicate_id, id->where, "requirement id", id->value,
                       first->second);
  }
}

std::string RequirementIds::next_for(Metric metric) {
  std::string id(calc::name_of(metric));
  for (int repeat = 2; line_of_given_.contains(id) || !made_.insert(id).second; ++repeat) {
    id = fmt::format("{}-{}", calc::name_of(metric), repeat);
  }
  return id;
}

}  // namespace rules
