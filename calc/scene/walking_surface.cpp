#include "calc/scene/walking_surface.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

// Of the longest edge: two triangles that share an edge must leave no gap by rounding.
constexpr double kOnEdge = 1.0e-9;
constexpr double kUprightCosine = 1.0e-9;
constexpr double kSameSurface_m = 1.0e-9;

bool covers(const std::array<glm::dvec3, 3>& corner_m, const glm::dvec2& at_m) {
  double lowest = 0.0, highest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 from(corner_m[i]), edge = glm::dvec2(corner_m[(i + 1) % 3]) - from;
    const double length_m = glm::length(edge);
    if (!(length_m > 0.0)) return false;
    const glm::dvec2 offset = at_m - from;
    const double side_m = (edge.x * offset.y - edge.y * offset.x) / length_m;
    const double zero_m = kOnEdge * length_m;
    if (side_m < -zero_m) lowest = side_m;
    if (side_m > zero_m) highest = side_m;
  }
  return lowest == 0.0 || highest == 0.0;
}

}  // namespace

std::optional<double> height_at(const std::array<glm::dvec3, 3>& corner_m, const glm::dvec2& at_m) {
  const glm::dvec3 normal = glm::cross(corner_m[1] - corner_m[0], corner_m[2] - corner_m[0]);
  if (!(std::abs(normal.z) > kUprightCosine * glm::length(normal))) return std::nullopt;
  if (!covers(corner_m, at_m)) return std::nullopt;
  const glm::dvec2 offset = at_m - glm::dvec2(corner_m[0]);
  return corner_m[0].z - (normal.x * offset.x + normal.y * offset.y) / normal.z;
}

WalkingSurface::WalkingSurface(const Space& space, const glm::dvec3& lowest_m,
                               const glm::dvec3& highest_m)
    : has_ground_(!space.shell && space.surfaces_file.empty()) {
  for (const Body& body : space.bodies) {
    for (const glm::uvec3& t : body.triangle) {
      const std::array corner{body.vertex_m[t.x], body.vertex_m[t.y], body.vertex_m[t.z]};
      const glm::dvec3 low = glm::min(corner[0], glm::min(corner[1], corner[2]));
      const glm::dvec3 high = glm::max(corner[0], glm::max(corner[1], corner[2]));
      const bool is_beside =
          low.x > highest_m.x || low.y > highest_m.y || high.x < lowest_m.x || high.y < lowest_m.y;
      // What is below is still a reason not to assume a ground.
      const bool is_above = low.z > highest_m.z + kWalkingSearchUp_m;
      const bool is_below = !has_ground_ && high.z < lowest_m.z - kWalkingSearchDown_m;
      if (is_beside || is_above || is_below) continue;
      pieces_.push_back({corner, glm::dvec2(low), glm::dvec2(high), &body});
    }
  }
}

WalkingSurface::Found WalkingSurface::below(const glm::dvec3& at_m) const {
  std::optional<double> highest;
  const Body* body = nullptr;
  for (const Piece& piece : pieces_) {
    if (at_m.x < piece.low_m.x || at_m.y < piece.low_m.y || at_m.x > piece.high_m.x ||
        at_m.y > piece.high_m.y) {
      continue;
    }
    const std::optional<double> z = height_at(piece.corner_m, glm::dvec2(at_m));
    if (!z || *z > at_m.z + kWalkingSearchUp_m + kSameSurface_m || (highest && *z <= *highest)) {
      continue;
    }
    highest = z;
    body = piece.body;
  }
  if (!highest && has_ground_) highest = 0.0;
  if (!highest || *highest < at_m.z - kWalkingSearchDown_m - kSameSurface_m) return {};
  if (*highest <= at_m.z + kWalkingStepUp_m + kSameSurface_m) return {highest, nullptr};
  // Of the ground itself: the line lies below it.
  return body == nullptr ? Found{} : Found{std::nullopt, &body->id};
}

}  // namespace calc
