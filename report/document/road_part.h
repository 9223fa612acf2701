#pragma once
// A street of a project, with the values for its drivers. In the road's own frame, see
// calc/road/road_light.h: x along it, y across it from its right edge, metres.

#include "calc/road/road_light.h"

#include <optional>
#include <string>
#include <vector>

namespace report {

// Equal luminaires at x = shift + k * spacing for all whole k.
struct RoadRowPart {
  std::string id, type_id;
  std::string group = {};  // dimming group; "" = none
  double height_m = 0, y_m = 0, shift_m = 0;
  double tilt_deg = 0;  // > 0: the left side of the luminaire, towards +y, is lifted
  double power_w = 0;   // of one luminaire at full output; 0 = not stated
  double maintenance_factor = 1;
};

// A part of the street with its own plane: carriageway or footway.
struct RoadAreaPart {
  std::string plane_id, name;
  double from_y_m = 0, to_y_m = 0;  // from < to
};

struct RoadPart {
  double spacing_m = 0, width_m = 0;  // of the carriageway; > 0
  std::string surface;                // "R3"
  double q0 = 0;
  std::vector<RoadRowPart> rows;    // in the order of the project
  std::vector<RoadAreaPart> areas;  // the carriageway first
  std::string scene;                // whose light this is; "" = full output
  calc::RoadLight light;            // one observer for each lane, from the right edge
};

}  // namespace report
