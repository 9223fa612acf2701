#pragma once
// How luminaires stand in the room. Frames are orthonormal and right-handed; columns are the
// directions of C0, C90 and -axis (gamma = pi), so that direction_world = frame *
// direction_luminaire (frame of PhotometricWeb).

#include <glm/glm.hpp>

#include <optional>

namespace calc {

// Counter-clockwise seen from above.
glm::dmat3 rotation_about_z(double angle_rad);

// axis: direction of gamma = 0, any length but 0. For a luminaire that shines straight down, C0 =
// (cos r, sin r, 0) with r = rotation_rad; any other axis is reached from there by the smallest
// rotation, and straight up by half a turn about the x axis.
glm::dmat3 luminaire_frame(const glm::dvec3& axis, double rotation_rad);

// C0 = the part of c0 across the axis. Empty when c0 is zero or parallel to the axis (within 1e-9
// rad).
std::optional<glm::dmat3> luminaire_frame_towards(const glm::dvec3& axis, const glm::dvec3& c0);

}  // namespace calc
