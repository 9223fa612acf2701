#pragma once
// The quantities of a project's road that can be required, from its description: see road_light.h.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/road/road_light.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>

namespace calc {

// A quantity of the whole road.
struct RoadValue {
  Message problem;  // why there is no value, in words; "" = there is
  Estimate value{};
  Message words{};  // of every lane or edge, for reports
};

struct RoadValues {
  RoadValue luminance_cd_m2, uo, ul, ti_percent, rei;
  Message words{};       // by which standard
  Message stated{};      // what the project says of the road itself, which no design changes
  Message why_no_row{};  // why no row of a rule pack is about it, in words; "" = one may be
};

// Returns the layout of space.road with the levels of the scene; null: at full output.
RoadLayout road_layout(const Project& project, const Space& space, const LightScene* scene);

// Returns the method of calculation, for reports: once for a road.
Message road_method_words(const Road& road);

// Returns the values for the worst observer of each quantity, and the darker edge.
RoadValues road_values(const Project& project, const Space& space, const LightScene* scene);

}  // namespace calc
