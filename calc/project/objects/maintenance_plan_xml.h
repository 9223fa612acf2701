#pragma once
// <maintenance-plan>: how the installation is to be kept.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/maintenance_plan.h"

namespace calc {

// What one of its numbers may be.
inline const NumberRange& range_of(const MaintenanceNumber& one) {
  return one.number == &MaintenancePlan::use_h ? kHours : kPositive;
}

// The only one of the project; a second one is reported.
void read_maintenance_plan(ProjectContext& context, const XmlElement& root);

}  // namespace calc
