#pragma once
// Reads the task area of a <workplace> that is not level: a part of a wall, or a face in the room.

#include "calc/base/xml_reader.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/planes_xml.h"
#include "calc/scene/project.h"

#include <optional>

namespace calc {

// Reads wall="2" with along="0.5 3.5" and heights="0.9 2.1", or face="x1 y1 x2 y2" (its foot, from
// left to right for a viewer) with heights and lean. Empty: the workplace has none of these, or
// after an error, which is reported.
std::optional<UprightTask> read_upright_task(const ProjectContext& context, ElementReader& reader,
                                             const PlaneSurroundings& around);

// Returns whether the whole task area and its viewer are in the room.
bool lies_within(const UprightTask& task, const RoomShell& room);

// The extent of the task's plane within the room, along u and v. Requires a task within the room.
struct RoomBeside {
  glm::dvec2 from_m{0.0}, to_m{0.0};
};
RoomBeside room_beside(const UprightTask& task, const RoomShell& room);

}  // namespace calc
