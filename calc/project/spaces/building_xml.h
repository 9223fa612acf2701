#pragma once
// Reads <building>: rooms with common requirements.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// Requires that the rooms are read, because it names them. Errors are reported.
void read_buildings(ProjectContext& context, const XmlElement& root);

}  // namespace calc
