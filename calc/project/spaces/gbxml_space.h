#pragma once
// Reads a <room> whose surfaces come from a gbXML file.

#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/room_plan.h"

namespace calc {

// Reads the attributes "file", "space" and "material" and the children <map>; fills the space's
// name (if it has none) and bodies, named "<room>.<id in the file>". plan becomes GbxmlRoom's
// footprint, or has no corners. All of it may be missing after an error.
void read_gbxml_surfaces(ProjectContext& context, ElementReader& reader, Space& space,
                         RoomPlan& plan);

}  // namespace calc
