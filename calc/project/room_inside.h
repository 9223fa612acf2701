#pragma once
// What is within a room.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

namespace calc {

// Walls, floor and ceiling belong to it, within a micrometre.
bool room_contains(const RoomShell& shell, const glm::dvec3& point_m);

// How far a point is outside, in metres; 0 within the room.
double distance_outside_m(const RoomShell& shell, const glm::dvec3& point_m);

}  // namespace calc
