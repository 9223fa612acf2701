#pragma once
// Reads <workplace>: zones of a room by a row of a rule pack. This reads and checks all that does
// not need the pack; rules/ checks the names of all attributes and adds its own.

#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/planes_xml.h"

namespace calc {

// Reads all <workplace> of a room into space.workplaces; errors are reported.
void read_workplaces(ProjectContext& context, const XmlElement& room,
                     const PlaneSurroundings& surroundings, Space& space);

}  // namespace calc
