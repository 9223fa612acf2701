#include "calc/project/objects/maintenance_plan_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/reading/project_elements.h"

#include <string>

namespace calc {
namespace {

MaintenancePlan read_one(ProjectContext& context, const XmlElement& element) {
  ElementReader reader(element, context.diagnostics);
  reader.allow(kMaintenancePlanElement);
  MaintenancePlan plan;
  plan.environment = std::string(trim(reader.text_or("environment", "")));
  plan.instructions = std::string(trim(reader.text_or("instructions", "")));
  for (const MaintenanceNumber& one : kMaintenanceNumbers) {
    plan.*one.number = reader.optional_number(one.name, range_of(one));
  }
  return plan;
}

}  // namespace

void read_maintenance_plan(ProjectContext& context, const XmlElement& root) {
  int line = 0;
  for (const XmlElement& child : root.children) {
    if (child.name != kMaintenancePlanName) continue;
    MaintenancePlan plan = read_one(context, child);
    if (line == 0) {
      line = child.where.line;
      context.project.maintenance_plan = std::move(plan);
    } else {
      context.diagnostics.report(DiagnosticId::duplicate_id, child.where, "element",
                                 kMaintenancePlanName, line);
    }
  }
}

}  // namespace calc
