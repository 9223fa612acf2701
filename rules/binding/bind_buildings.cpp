#include "rules/binding/bind_buildings.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/reading/former_ids.h"
#include "rules/binding/requirement_ids.h"
#include "rules/binding/requirement_reader.h"

#include <string>
#include <utility>

namespace rules {
namespace {

// "power-density, LENI"
std::string allowed_quantities() {
  std::string names;
  for (const auto& metric : calc::EnumNames<Metric>::list) {
    if (!adds_up_over_rooms(metric.value)) continue;
    names += names.empty() ? "" : ", ";
    names += metric.name;
  }
  return names;
}

}  // namespace

std::vector<BuildingQuestion> bind_buildings(const calc::Project& project,
                                             const std::vector<RulePack>& packs,
                                             calc::Diagnostics& diagnostics) {
  std::vector<BuildingQuestion> questions;
  for (std::size_t b = 0; b < project.buildings.size(); ++b) {
    const std::vector<calc::RequirementText>& texts = project.buildings[b].requirements;
    RequirementIds ids(texts, diagnostics);
    calc::FormerIds former("requirement");
    for (const calc::RequirementText& text : texts) {
      const RequirementContext context{calc::ReceiverKernel::planar, project.scenes, packs};
      for (Requirement& requirement : read_requirement(text, context, diagnostics)) {
        for (const StatedDeviation& stated : requirement.stated_deviations) {
          diagnostics.report(calc::DiagnosticId::deviation_of_building, stated.by.where);
        }
        if (!adds_up_over_rooms(requirement.metric)) {
          diagnostics.report(calc::DiagnosticId::quantity_not_of_building, requirement.where,
                             calc::name_of(requirement.metric), allowed_quantities());
          continue;
        }
        // What counts only in aggregates of rooms is asked by itself here.
        if (requirement.severity == Severity::in_aggregate) requirement.severity = Severity::shall;
        if (requirement.id.empty()) requirement.id = ids.next_for(requirement.metric);
        former.add(requirement.id, requirement.where.line, requirement.was, requirement.where);
        questions.push_back({b, std::move(requirement)});
      }
    }
    former.check(diagnostics);
  }
  return questions;
}

}  // namespace rules
