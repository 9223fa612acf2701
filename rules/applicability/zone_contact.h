#pragma once
// How a plane lies in relation to another zone of its room, and to the surface people stand on.

#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <optional>
#include <string>

namespace rules {

struct ZoneContact {
  std::size_t inside = 0;  // points over, under or in the zone: along its normal, at any distance
  double nearest_m;        // of a point to the zone's outline, seen so; 0 inside; infinite: no area
};
ZoneContact contact_with(const calc::CalcPlane& zone, const calc::SensorGrid& points);

// A surface under some of a plane's points that people may stand on: at least as high as a step,
// and too far below the plane to be a desk.
struct Platform {
  std::string id;
  double height_m;  // above the floor
};
// Returns the platform below most of the points in rooms, where heights start at the floor. Empty:
// there is none.
std::optional<Platform> platform_below(const calc::CalcPlane& plane, const calc::SensorGrid& points,
                                       const calc::Space& space);

}  // namespace rules
