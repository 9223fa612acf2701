#pragma once
// Reads <about>: who the design is for and who made it.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// Reads the only one of the project; a second one is reported.
void read_about(ProjectContext& context, const XmlElement& root);

}  // namespace calc
