#pragma once
// How far a point is from a triangle, in double.

#include "calc/rays/triangle_hit.h"

namespace calc {

// From the nearest point of the triangle.
double distance_m(const glm::dvec3& point_m, const Triangle& triangle);

// From the part of the triangle that reaches more than height_m in front of the plane through the
// point with this unit normal; infinity if no part does.
double distance_in_front_m(const glm::dvec3& point_m, const glm::dvec3& normal, double height_m,
                           const Triangle& triangle);

}  // namespace calc
