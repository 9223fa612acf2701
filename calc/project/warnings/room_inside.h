#pragma once
// What is within a room.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <vector>

namespace calc {

// Walls, floor and ceiling belong to it, within a micrometre.
bool room_contains(const RoomShell& shell, const glm::dvec3& point_m);

// Whether a convex polygon of at least 2 corners, in one plane, reaches more than a centimetre into
// it: what stands on a wall, or in one, does not.
bool reaches_into(const RoomShell& shell, const std::vector<glm::dvec3>& corners_m);

// Whether two rooms have space in common that is more than a centimetre wide, long and high.
bool share_space(const RoomShell& a, const RoomShell& b);

// How far a point is outside, in metres; 0 within the room.
double distance_outside_m(const RoomShell& shell, const glm::dvec3& point_m);

}  // namespace calc
