#include "rules/zones/zone_outline.h"

#include "calc/base/elementary.h"
#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rules {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

glm::dvec2 size_of(const Polygon& outline) {
  glm::dvec2 lower = outline[0], upper = outline[0];
  for (const glm::dvec2& corner : outline) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  return upper - lower;
}

Polygon along_axis(const Polygon& polygon, glm::dvec2 axis) {
  Polygon turned;
  for (const glm::dvec2& p : polygon) turned.emplace_back(glm::dot(p, axis), cross(axis, p));
  return turned;
}

Polygon back_from(const Polygon& polygon, glm::dvec2 axis) {
  return along_axis(polygon, {axis.x, -axis.y});
}

double least_distance(const Polygon& inner, const Polygon& outer) {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec2& p : inner) least = std::min(least, calc::distance_to_boundary(outer, p));
  for (const glm::dvec2& p : outer) least = std::min(least, calc::distance_to_boundary(inner, p));
  return least;
}

std::vector<Polygon> wall_strips(const Polygon& room, double width_m) {
  const std::size_t n = room.size();
  const auto along = [&](std::size_t i) { return glm::normalize(room[(i + 1) % n] - room[i % n]); };
  // How far the strips of two walls are apart at the corner between them.
  const auto gap_m = [&](glm::dvec2 before, glm::dvec2 after) {
    const double turn = cross(before, after);
    if (turn >= 0.0) return 0.0;
    const double straight = std::max(1.0 + glm::dot(before, after), 1.0e-3);
    return std::min(1.0, -turn / straight) * width_m;
  };
  std::vector<Polygon> strips;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 u = along(i), inwards = glm::dvec2(-u.y, u.x) * width_m;
    const glm::dvec2 from = room[i] - gap_m(along(i + n - 1), u) * u;
    const glm::dvec2 to = room[(i + 1) % n] + gap_m(u, along(i + 1)) * u;
    strips.push_back({from, to, to + inwards, from + inwards});
  }
  return strips;
}

double lost_to_margin_m2(const Polygon& room, double margin_m) {
  constexpr double kReach = 2.0;  // margins from a point that counts; corners are nearer
  const int samples = room.size() > 200 ? 24 : 64;
  glm::dvec2 lower = room[0];
  for (const glm::dvec2& corner : room) lower = glm::min(lower, corner);
  const glm::dvec2 step = size_of(room) / static_cast<double>(samples);
  const auto counts = [&](glm::dvec2 p) {
    return calc::distance_to_boundary(room, p) >= margin_m && calc::contains_point(room, p);
  };
  const auto is_near = [&](glm::dvec2 p) {
    constexpr int kTurns = 16, kSteps = 4;
    if (counts(p)) return true;
    for (int i = 0; i < kTurns * kSteps; ++i) {
      const double angle = 6.283185307179586 * (i % kTurns) / kTurns;
      const double radius = kReach * margin_m * (i / kTurns + 1) / kSteps;
      if (counts(p + radius * glm::dvec2(calc::cos(angle), calc::sin(angle)))) return true;
    }
    return false;
  };
  int lost = 0;
  for (int i = 0; i < samples * samples; ++i) {
    const glm::dvec2 p = lower + step * glm::dvec2(i % samples + 0.5, i / samples + 0.5);
    if (calc::contains_point(room, p) && !is_near(p)) ++lost;
  }
  return lost * step.x * step.y;
}

}  // namespace rules
