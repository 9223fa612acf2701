#include "calc/project/warnings/room_inside.h"

#include "calc/scene/polygon.h"

#include <algorithm>

namespace calc {
namespace {

constexpr double kOnBoundary_m = 1.0e-6;
constexpr double kDeep_m = 0.01;

using FlatPolygon2 = std::vector<glm::dvec2>;

// Along one direction: no more in common than kDeep_m, or than the narrower one has.
bool are_apart_along(const glm::dvec2& direction, const FlatPolygon2& a, const FlatPolygon2& b) {
  const auto range = [&](const FlatPolygon2& polygon) {
    double low = glm::dot(direction, polygon[0]), high = low;
    for (const glm::dvec2& p : polygon) {
      low = std::min(low, glm::dot(direction, p));
      high = std::max(high, glm::dot(direction, p));
    }
    return glm::dvec2(low, high);
  };
  const glm::dvec2 ra = range(a), rb = range(b);
  return std::min(ra[1] - rb[0], rb[1] - ra[0]) <= kDeep_m;
}

// Separating axes of two convex polygons; one of them may be a line.
bool overlap_deeply(const FlatPolygon2& a, const FlatPolygon2& b) {
  for (const FlatPolygon2* polygon : {&a, &b}) {
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const glm::dvec2 side = (*polygon)[(i + 1) % polygon->size()] - (*polygon)[i];
      const double length_m = glm::length(side);
      if (!(length_m > kOnBoundary_m)) continue;
      for (const glm::dvec2& direction : {glm::dvec2(-side.y, side.x), side}) {
        if (are_apart_along(direction / length_m, a, b)) return false;
      }
    }
  }
  return true;
}

std::vector<FlatPolygon2> triangles_of(const FlatPolygon2& footprint) {
  std::vector<FlatPolygon2> triangles;
  const auto found = triangulate_polygon(footprint);
  if (!found) return triangles;
  for (const glm::uvec3& t : *found) {
    triangles.push_back({footprint[t.x], footprint[t.y], footprint[t.z]});
  }
  return triangles;
}

// The part of a convex polygon above a height, or (sign -1) below.
std::vector<glm::dvec3> part_beyond(const std::vector<glm::dvec3>& polygon, double z_m,
                                    double sign) {
  std::vector<glm::dvec3> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double hp = sign * (p.z - z_m), hq = sign * (q.z - z_m);
    if (hp >= 0.0) part.push_back(p);
    if (hp * hq < 0.0) part.push_back(p + (hp / (hp - hq)) * (q - p));
  }
  return part;
}

}  // namespace

bool reaches_into(const RoomShell& shell, const std::vector<glm::dvec3>& corners_m) {
  const double top_m = shell.floor_z_m + shell.height_m;
  const std::vector<glm::dvec3> within =
      part_beyond(part_beyond(corners_m, shell.floor_z_m + kDeep_m, 1.0), top_m - kDeep_m, -1.0);
  if (within.size() < 2) return false;
  FlatPolygon2 seen;
  for (const glm::dvec3& p : within) seen.emplace_back(p);
  for (const FlatPolygon2& part : triangles_of(shell.footprint_m)) {
    if (overlap_deeply(seen, part)) return true;
  }
  return false;
}

bool share_space(const RoomShell& a, const RoomShell& b) {
  const double low_m = std::max(a.floor_z_m, b.floor_z_m),
               high_m = std::min(a.floor_z_m + a.height_m, b.floor_z_m + b.height_m);
  if (high_m - low_m <= kDeep_m) return false;
  const std::vector<FlatPolygon2> parts = triangles_of(b.footprint_m);
  for (const FlatPolygon2& one : triangles_of(a.footprint_m)) {
    for (const FlatPolygon2& other : parts) {
      if (overlap_deeply(one, other)) return true;
    }
  }
  return false;
}

bool room_contains(const RoomShell& shell, const glm::dvec3& point_m) {
  if (point_m.z < shell.floor_z_m - kOnBoundary_m) return false;
  if (point_m.z > shell.floor_z_m + shell.height_m + kOnBoundary_m) return false;
  const glm::dvec2 foot(point_m);
  return contains_point(shell.footprint_m, foot) ||
         distance_to_boundary(shell.footprint_m, foot) <= kOnBoundary_m;
}

double distance_outside_m(const RoomShell& shell, const glm::dvec3& point_m) {
  if (room_contains(shell, point_m)) return 0.0;
  const glm::dvec2 foot(point_m);
  const double sideways_m =
      contains_point(shell.footprint_m, foot) ? 0.0 : distance_to_boundary(shell.footprint_m, foot);
  const double upright_m =
      std::max({0.0, shell.floor_z_m - point_m.z, point_m.z - shell.floor_z_m - shell.height_m});
  return glm::length(glm::dvec2(sideways_m, upright_m));
}

}  // namespace calc
