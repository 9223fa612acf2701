#pragma once
// Whether a ray meets a triangle, and where: the one rule, in double, that all traversals obey.
// What comes out is a function of ray and triangle alone, the same bits on every processor.

#include "calc/base/triangle.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace calc {

// A ray, or a segment from `origin`: points origin + t * direction with least < t < most. As it is
// stored, so that nothing is rounded on the way. The direction need not be a unit one.
struct Ray {
  glm::vec3 origin, direction;
  float least = 0.0f, most = std::numeric_limits<float>::infinity();
};

struct TriangleHit {
  std::uint32_t triangle = 0xffff'ffff;
  double t = std::numeric_limits<double>::infinity();
  double u = 0.0, v = 0.0;  // the point is a + u (b - a) + v (c - a)

  // Nearer first; of equally near ones the triangle that comes first, so that the order in which
  // triangles are tried does not matter.
  bool is_before(const TriangleHit& other) const {
    return t < other.t || (t == other.t && triangle < other.triangle);
  }
};

// True if the ray meets the triangle, whose corners are as they are stored, widened; sets t, u and
// v. From either side. The ray's side of an edge
// is one and the same number, up to its sign, for both triangles that share the edge, and an edge
// belongs to both: no ray slips between them. A ray in the plane of a triangle, as far as double
// can tell, does not meet it. Directions are between 1e-12 and 1e12 long. [Woop13, with the edge
// functions in three dimensions]
bool meets(const Ray& ray, const Triangle& triangle, TriangleHit& hit);

}  // namespace calc
