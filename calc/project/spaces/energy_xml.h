#pragma once
// <energy>: hours and factors of a room, or of all rooms of a project that have none of their own.

#include "calc/base/xml_document.h"
#include "calc/project/reading/project_context.h"

namespace calc {

// After the rooms, whose luminaires' groups may be named. Project::spaces begins with the root's
// <room> elements, in order.
void read_energy(ProjectContext& context, const XmlElement& root);

}  // namespace calc
