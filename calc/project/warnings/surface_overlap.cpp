#include "calc/project/warnings/surface_overlap.h"

#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace calc {
namespace {

constexpr double kTolerance_m = 1.0e-6;

using Triangle2 = std::array<glm::dvec2, 3>;

// Separating axes: the sides of `one`.
bool separated_by_sides(const Triangle2& one, const Triangle2& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 side = one[(i + 1) % 3] - one[i];
    const double length = glm::length(side);
    if (length < kTolerance_m) return true;  // no area to speak of
    const glm::dvec2 across(-side.y / length, side.x / length);
    const double inside = glm::dot(one[(i + 2) % 3] - one[i], across);
    const double sign = inside < 0.0 ? -1.0 : 1.0;
    double reach = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2& corner : other) {
      reach = std::max(reach, sign * glm::dot(corner - one[i], across));
    }
    if (reach <= kTolerance_m) return true;
  }
  return false;
}

bool overlap(const Triangle2& a, const Triangle2& b) {
  return !separated_by_sides(a, b) && !separated_by_sides(b, a);
}

}  // namespace

SurfaceOverlap::SurfaceOverlap(const PlanarArea& area) : area_(area) {
  const std::optional<std::vector<glm::uvec3>> triangles = triangulate_polygon(area.outline_m);
  if (!triangles) return;
  for (const glm::uvec3& t : *triangles) {
    triangles_.push_back({area.outline_m[t.x], area.outline_m[t.y], area.outline_m[t.z]});
  }
}

glm::dvec3 SurfaceOverlap::local(const glm::dvec3& point) const {
  const glm::dvec3 offset = point - area_.origin_m;
  return {glm::dot(offset, area_.u), glm::dot(offset, area_.v), glm::dot(offset, area_.normal())};
}

bool SurfaceOverlap::touches_plane(const Body& body) const {
  std::size_t corners = 0;
  for (const glm::dvec3& vertex : body.vertex_m) {
    if (std::abs(local(vertex).z) <= kTolerance_m && ++corners == 3) return true;
  }
  return false;
}

bool SurfaceOverlap::with(const Body& body) const {
  if (!touches_plane(body)) return false;
  for (const glm::uvec3& index : body.triangle) {
    const std::array<glm::dvec3, 3> corner{local(body.vertex_m[index.x]),
                                           local(body.vertex_m[index.y]),
                                           local(body.vertex_m[index.z])};
    const bool in_plane = std::all_of(corner.begin(), corner.end(), [](const glm::dvec3& c) {
      return std::abs(c.z) <= kTolerance_m;
    });
    if (!in_plane) continue;
    const Triangle2 surface{glm::dvec2(corner[0]), glm::dvec2(corner[1]), glm::dvec2(corner[2])};
    for (const Triangle& part : triangles_) {
      if (overlap(part, surface)) return true;
    }
  }
  return false;
}

}  // namespace calc
