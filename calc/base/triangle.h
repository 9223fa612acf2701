#pragma once
// One triangle in space: how far a point is from it, and what it divides, in double.

#include <glm/glm.hpp>

namespace calc {

struct Triangle {
  glm::dvec3 a, b, c;
};

// From the nearest point of the triangle.
double distance_m(const glm::dvec3& point_m, const Triangle& triangle);

// From the part of the triangle that reaches more than height_m in front of the plane through the
// point with this unit normal; infinity if no part does.
double distance_in_front_m(const glm::dvec3& point_m, const glm::dvec3& normal, double height_m,
                           const Triangle& triangle);

// Whether the triangle stands between two places, neither of which lies in its plane. Its edges
// belong to it.
bool divides(const Triangle& triangle, const glm::dvec3& from_m, const glm::dvec3& to_m);

}  // namespace calc
