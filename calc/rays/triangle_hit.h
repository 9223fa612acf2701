#pragma once
// Tests whether a ray meets a triangle, and where: the single rule, in double, for all traversals.
// The result depends only on ray and triangle, the same bits on every processor.

#include "calc/base/triangle.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace calc {

// A ray, or a segment from `origin`: points origin + t * direction with least < t < most. It is
// used as stored, without further rounding. The direction need not be a unit one.
struct Ray {
  glm::vec3 origin, direction;
  float least = 0.0f, most = std::numeric_limits<float>::infinity();
};

struct TriangleHit {
  std::uint32_t triangle = 0xffff'ffff;
  double t = std::numeric_limits<double>::infinity();
  double u = 0.0, v = 0.0;  // the point is a + u (b - a) + v (c - a)

  // Returns whether it is nearer; of equally near hits the lower triangle is first, so that the
  // order in which triangles are tried does not matter.
  bool is_before(const TriangleHit& other) const {
    return t < other.t || (t == other.t && triangle < other.triangle);
  }
};

// Returns whether the ray meets the triangle, whose stored corners are widened to double; sets t, u
// and v. From either side. The ray's side of an edge is the same number, up to its sign, for both
// triangles that share the edge, and an edge belongs to both: no ray passes between them. A ray in
// the plane of a triangle, to the accuracy of double, does not meet it. Directions are between
// 1e-12 and 1e12 long. [Woop13, with the edge functions in three dimensions]
bool meets(const Ray& ray, const Triangle& triangle, TriangleHit& hit);

}  // namespace calc
