#pragma once
// Tests what is within a room.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// Returns whether the room, with its walls, floor and ceiling, contains it within a micrometre.
bool room_contains(const RoomShell& shell, const glm::dvec3& point_m);

// Returns whether a convex polygon of at least 2 corners, in one plane, reaches more than a
// centimetre into it, unlike things on or in a wall.
bool reaches_into(const RoomShell& shell, const std::vector<glm::dvec3>& corners_m);

// Returns whether two rooms share space more than a centimetre wide, long and high.
bool share_space(const RoomShell& a, const RoomShell& b);

// Returns the distance of a point from the room, in metres; 0 within it.
double distance_outside_m(const RoomShell& shell, const glm::dvec3& point_m);

}  // namespace calc
