#pragma once
// One triangle in space: its distance from points and the places it separates, in double.

#include <glm/glm.hpp>

namespace calc {

struct Triangle {
  glm::dvec3 a, b, c;
};

// Returns the distance from the nearest point of the triangle.
double distance_m(const glm::dvec3& point_m, const Triangle& triangle);

// Returns the distance from the part of the triangle more than height_m in front of the plane
// through the point with this unit normal; infinity if there is none.
double distance_in_front_m(const glm::dvec3& point_m, const glm::dvec3& normal, double height_m,
                           const Triangle& triangle);

// Returns whether the triangle, edges included, is between two places, neither of them in its
// plane.
bool divides(const Triangle& triangle, const glm::dvec3& from_m, const glm::dvec3& to_m);

}  // namespace calc
