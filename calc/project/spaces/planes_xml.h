#pragma once
// <plane> in all its forms.

#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/room_plan.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace calc {

// Where a room's surfaces come from.
enum class RoomSource { prism, gbxml, mesh };

// What a plane may refer to. The flags are false when errors there were reported already, so that
// nothing that follows from them is reported again.
struct PlaneSurroundings {
  const RoomPlan* room = nullptr;  // null in the open space
  // Of a room of a file `room` is the floor, if that is one flat polygon, and no prism.
  RoomSource source = RoomSource::prism;
  bool room_is_good = true;
  bool objects_are_good = true;
  glm::dvec3 origin_m{0.0};                             // of the coordinates in the file
  std::map<std::string, BoxTop, std::less<>> box_tops;  // world coordinates
};

// The attributes count, spacing and rounding; `is_given` only if there is one of them.
struct GridText {
  GridRule rule;
  bool is_given = false;
};
GridText read_grid(ProjectContext& context, ElementReader& reader);

// What every element has that is a plane: id, name, place and requirements.
CalcPlane read_named_plane(ProjectContext& context, ElementReader& reader);

// After an error only its id and its requirements are of use.
CalcPlane read_plane(ProjectContext& context, ElementReader& reader,
                     const PlaneSurroundings& surroundings);

}  // namespace calc
