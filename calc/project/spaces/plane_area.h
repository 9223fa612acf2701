#pragma once
// Makes planar areas from the shapes in project files. All coordinates are world coordinates.

#include "calc/project/spaces/room_plan.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace calc {

// Returns an area that faces u x v. Requires u and v perpendicular within rounding, not zero.
PlanarArea rectangle_area(const Rectangle& rectangle);

// Returns the direction of the longest straight side of a simple outline, which may be drawn in
// pieces, turned by right angles until it is closest to +x: for an outline along the axes it is +x
// itself.
glm::dvec2 long_axis(const std::vector<glm::dvec2>& outline);

// Returns the smaller side of the rectangle around an outline along its long axis, or the diameter
// of the largest circle in it (to half a centimetre), if that is less; at most most_m.
double width_up_to(const std::vector<glm::dvec2>& outline, double most_m);

// Returns the whole footprint at `height_m` above the floor, facing up (u = its long axis, v across
// it) or down (v reversed). A grid along x and y would miss the sides of a rotated room.
PlanarArea horizontal_area(const RoomPlan& room, double height_m, bool faces_up);

// Returns the area that faces the side from which the corners run counter-clockwise; u is along the
// first side, or along the long axis if the first side is at an angle to it, because a cut-off
// corner is no side of a grid. Empty if the corners are not in one plane or not a simple polygon.
std::optional<PlanarArea> polygon_area(const std::vector<glm::dvec3>& corners);

// Returns coordinates along u and v.
glm::dvec2 area_coordinates(const PlanarArea& area, const glm::dvec3& point);

// Returns whether the point is in the plane within 1e-6 of the outline's size, and within the
// outline or on it; ignores holes.
bool lies_in_area(const PlanarArea& area, const glm::dvec3& point);

}  // namespace calc
