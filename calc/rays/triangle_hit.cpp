#include "calc/rays/triangle_hit.h"

#include <algorithm>

#include "calc/base/shader_words.h"

#define EXACT const  // -ffp-contract=off does it

namespace calc {
namespace {

#include "calc/rays/triangle_terms.glsl"

// A ray goes through a place that is no farther from it than this, times the largest coordinate of
// the place from the origin and of the origin: 4 roundings of single precision, within what
// searches allow for (tree_kernels.cpp). Only rays within some 1e-9 of the triangle's plane are off
// by more.
constexpr double kMostOff = 0x1p-22;

}  // namespace

bool meets(const Ray& ray, const Triangle& triangle, TriangleHit& hit) {
  const auto& [a, b, c] = triangle;
  const glm::dvec3 origin(ray.origin), direction(ray.direction);
  const glm::dvec3 side = sides_of(origin, direction, a, b, c);
  const double lowest = std::min({side.x, side.y, side.z});
  const double highest = std::max({side.x, side.y, side.z});
  if (lowest < 0.0 && highest > 0.0) return false;
  const double sum = side.x + side.y + side.z;
  if (sum == 0.0) return false;
  const double u = side.y / sum, v = side.z / sum;
  // The place, from the origin; it lies in the triangle, whatever rounding did to the sides.
  const glm::dvec3 place = (a - origin) + u * (b - a) + v * (c - a);
  const double t = glm::dot(place, direction) / glm::dot(direction, direction);
  if (!(t > static_cast<double>(ray.least) && t < static_cast<double>(ray.most))) return false;
  // In the plane of the triangle the sides are nothing but rounding, and the place is not on the
  // ray.
  const glm::dvec3 off = glm::abs(place - t * direction);
  const glm::dvec3 far = glm::abs(place) + glm::abs(origin);
  if (std::max({off.x, off.y, off.z}) > kMostOff * std::max({far.x, far.y, far.z})) return false;
  hit.t = t;
  hit.u = u;
  hit.v = v;
  return true;
}

}  // namespace calc

#undef EXACT
#include "calc/base/shader_words_end.h"
