#pragma once
// <workplace>: zones of a room by a row of a rule pack. What can be known without the pack is read
// and checked here; the names of all its attributes are checked by rules/, which adds its own.

#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/planes_xml.h"

namespace calc {

// All <workplace> of a room into space.workplaces; errors are reported.
void read_workplaces(ProjectContext& context, const XmlElement& room,
                     const PlaneSurroundings& surroundings, Space& space);

}  // namespace calc
