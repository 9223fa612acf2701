#pragma once
// The orientation of luminaires in the room. Frames are orthonormal and right-handed; columns are
// the directions of C0, C90 and -axis (gamma = pi), so that direction_world = frame *
// direction_luminaire (frame of PhotometricWeb).

#include <glm/glm.hpp>

#include <optional>

namespace calc {

// Returns the rotation, counter-clockwise seen from above.
glm::dmat3 rotation_about_z(double angle_rad);

// Returns the frame of a luminaire. axis: direction of gamma = 0, any length but 0. For a luminaire
// that shines straight down, C0 = (cos r, sin r, 0) with r = rotation_rad; the smallest rotation
// leads from there to any other axis, and half a turn about the x axis leads straight up.
glm::dmat3 luminaire_frame(const glm::dvec3& axis, double rotation_rad);

// Returns the frame whose C0 is the part of c0 across the axis. Empty when c0 is zero or parallel
// to the axis (within 1e-9 rad).
std::optional<glm::dmat3> luminaire_frame_towards(const glm::dvec3& axis, const glm::dvec3& c0);

}  // namespace calc
