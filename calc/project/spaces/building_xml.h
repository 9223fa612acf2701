#pragma once
// <building>: rooms of which something is asked together.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// After the rooms, which it names. Errors are reported.
void read_buildings(ProjectContext& context, const XmlElement& root);

}  // namespace calc
