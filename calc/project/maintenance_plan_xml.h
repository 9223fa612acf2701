#pragma once
// <maintenance-plan>: how the installation is to be kept.

#include "calc/base/xml_document.h"
#include "calc/project/project_context.h"

namespace calc {

// The only one of the project; a second one is reported.
void read_maintenance_plan(ProjectContext& context, const XmlElement& root);

}  // namespace calc
