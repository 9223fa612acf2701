#pragma once
// Reads <plane> in all its forms.

#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/spaces/room_plan.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace calc {

// The kind of element that a room's surfaces come from.
enum class RoomSource { prism, gbxml, mesh };

// Things that a plane may refer to. The flags are false when errors there were reported already, so
// that consequences of them are not reported again.
struct PlaneSurroundings {
  const RoomPlan* room = nullptr;  // null in the open space
  // In a room from a file, `room` is the floor, if that is one flat polygon, and not a prism.
  RoomSource source = RoomSource::prism;
  bool room_is_good = true;
  bool objects_are_good = true;
  glm::dvec3 origin_m{0.0};                             // of the coordinates in the file
  std::map<std::string, BoxTop, std::less<>> box_tops;  // world coordinates
};

// The attributes count, spacing and rounding; `is_given` only if at least one is present.
struct GridText {
  GridRule rule;
  bool is_given = false;
};
GridText read_grid(ProjectContext& context, ElementReader& reader);

// Returns a plane with the attributes of every plane element: id, name, place and requirements.
CalcPlane read_named_plane(ProjectContext& context, ElementReader& reader);

// Returns a plane; after an error only its id and its requirements are of use.
CalcPlane read_plane(ProjectContext& context, ElementReader& reader,
                     const PlaneSurroundings& surroundings);

}  // namespace calc
