#include "calc/base/triangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace calc {
namespace {

// Closest point of a triangle.  [Ericson05, 5.1.5]
glm::dvec3 closest_on_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

}  // namespace

double distance_m(const glm::dvec3& point_m, const Triangle& triangle) {
  return glm::length(closest_on_triangle(point_m, triangle.a, triangle.b, triangle.c) - point_m);
}

double distance_in_front_m(const glm::dvec3& point_m, const glm::dvec3& normal, double height_m,
                           const Triangle& triangle) {
  const std::array<glm::dvec3, 3> corner{triangle.a, triangle.b, triangle.c};
  std::array<glm::dvec3, 4> kept;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 &from = corner[k], &to = corner[(k + 1) % 3];
    const double h = glm::dot(normal, from - point_m) - height_m;
    const double next = glm::dot(normal, to - point_m) - height_m;
    if (h > 0.0) kept[count++] = from;
    if ((h > 0.0) != (next > 0.0)) kept[count++] = from + h / (h - next) * (to - from);
  }
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 2; k < count; ++k) {
    least_m = std::min(least_m, distance_m(point_m, {kept[0], kept[k - 1], kept[k]}));
  }
  return least_m;
}

bool divides(const Triangle& triangle, const glm::dvec3& from_m, const glm::dvec3& to_m) {
  const auto& [a, b, c] = triangle;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double from = glm::dot(normal, from_m - a), to = glm::dot(normal, to_m - a);
  if ((from > 0.0) == (to > 0.0)) return false;
  const glm::dvec3 at = from_m + from / (from - to) * (to_m - from_m);
  const double ab = glm::dot(normal, glm::cross(b - a, at - a));
  const double bc = glm::dot(normal, glm::cross(c - b, at - b));
  const double ca = glm::dot(normal, glm::cross(a - c, at - c));
  return ab >= 0.0 && bc >= 0.0 && ca >= 0.0;
}

}  // namespace calc
