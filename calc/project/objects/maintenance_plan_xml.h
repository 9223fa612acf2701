#pragma once
// Reads <maintenance-plan>: how the installation is to be kept.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/maintenance_plan.h"

namespace calc {

// Returns the allowed range of a number of the plan.
inline const NumberRange& range_of(const MaintenanceNumber& one) {
  return one.number == &MaintenancePlan::use_h ? kHours : kPositive;
}

// Reads the only one of the project; a second one is reported.
void read_maintenance_plan(ProjectContext& context, const XmlElement& root);

}  // namespace calc
