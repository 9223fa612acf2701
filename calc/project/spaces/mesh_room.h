#pragma once
// Reads a <room> whose surfaces come from a mesh file.

#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/room_plan.h"

namespace calc {

// Reads the attributes "file" and the others of read_placed_mesh(), and "shell". Fills the space's
// bodies: "<room>.shell" (encloses_room, or open with a warning), "<room>.solid1" ..., which are
// closed bodies in it, and "<room>.sheets", all other surfaces. plan becomes the floor's outline
// (find_floor()), or has no corners. All of it may be missing after an error.
//
// Objects of the file are divided into shells first, then the rest of all objects together. Without
// "shell" the room is the closed shell that contains everything else, or, if no closed shell
// reaches as far, all open surfaces together. An ambiguous file is an error: several shells side by
// side, or one in another that may be the room in a thick building. With shell="all" there is no
// "<room>.shell": every closed shell is a solid, and the room is between.
void read_mesh_surfaces(ProjectContext& context, ElementReader& reader, Space& space,
                        RoomPlan& plan);

}  // namespace calc
