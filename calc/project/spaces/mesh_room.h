#pragma once
// A <room> whose surfaces come from a mesh file.

#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/room_plan.h"

namespace calc {

// Attributes "file" and the others of read_placed_mesh(), and "shell". Fills the space's bodies:
// "<room>.shell" (encloses_room, or open and said), "<room>.solid1" ..., which are closed and stand
// in it, and "<room>.sheets", all other surfaces. plan becomes the floor's outline (find_floor()),
// or has no corners. All of it may be missing after an error.
//
// Objects of the file are taken apart into shells first, then what is left of all objects together.
// Without "shell" the room is the closed shell that has everything else in it, or, if nothing is
// closed that reaches as far, all open surfaces together. It is an error if that is not clear:
// several shells side by side, or one in the other that may be the room in a thick building. With
// shell="all" there is no "<room>.shell": all that is closed is a solid, and the room is between.
void read_mesh_surfaces(ProjectContext& context, ElementReader& reader, Space& space,
                        RoomPlan& plan);

}  // namespace calc
