#pragma once
// The task area of a <workplace> that is no level area: a part of a wall, or a face that stands in
// the room, as the project writes it.

#include "calc/base/xml_reader.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/planes_xml.h"
#include "calc/scene/project.h"

#include <optional>

namespace calc {

// By wall="2" with along="0.5 3.5" and heights="0.9 2.1", or by face="x1 y1 x2 y2" (its foot, from
// left to right as whoever looks at it sees it) with heights and lean. Empty: the workplace has
// none of these, or after an error, which is reported.
std::optional<UprightTask> read_upright_task(const ProjectContext& context, ElementReader& reader,
                                             const PlaneSurroundings& around);

// Whether all of it is in the room, and whoever looks at it, too.
bool lies_within(const UprightTask& task, const RoomShell& room);

// How far its plane goes within the room, along u and v of the area. The task lies within the room.
struct RoomBeside {
  glm::dvec2 from_m{0.0}, to_m{0.0};
};
RoomBeside room_beside(const UprightTask& task, const RoomShell& room);

}  // namespace calc
