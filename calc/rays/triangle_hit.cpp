#include "calc/rays/triangle_hit.h"

#include <algorithm>

#include "calc/shader_words.h"

#define EXACT const  // -ffp-contract=off does it

namespace calc {
namespace {

#include "calc/rays/triangle_terms.glsl"

}  // namespace

bool meets(const Ray& ray, const Triangle& triangle, TriangleHit& hit) {
  const auto& [a, b, c] = triangle;
  const glm::dvec3 origin(ray.origin), direction(ray.direction);
  const glm::dvec3 side = sides_of(origin, direction, a, b, c);
  const double lowest = std::min({side.x, side.y, side.z});
  const double highest = std::max({side.x, side.y, side.z});
  if (lowest < 0.0 && highest > 0.0) return false;
  const double sum = side.x + side.y + side.z;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double slope = glm::dot(normal, direction);
  if (sum == 0.0 || slope == 0.0) return false;
  const double t = glm::dot(normal, a - origin) / slope;
  if (!(t > static_cast<double>(ray.least) && t < static_cast<double>(ray.most))) return false;
  hit.t = t;
  hit.u = side.y / sum;
  hit.v = side.z / sum;
  return true;
}

}  // namespace calc

#undef EXACT
#include "calc/shader_words_end.h"
