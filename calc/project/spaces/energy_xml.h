#pragma once
// Reads <energy>: hours and factors of a room, or of all rooms of a project without their own.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// Requires that the rooms are read, because it may name their luminaires' groups. Project::spaces
// begins with the root's <room> elements, in order.
void read_energy(ProjectContext& context, const XmlElement& root);

}  // namespace calc
