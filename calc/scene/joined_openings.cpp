#include "calc/scene/joined_openings.h"

#include "calc/base/units.h"
#include "calc/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace calc {
namespace {

constexpr double kOfSide = 0.1;
constexpr double kParallel = 0.9962;  // cosine of 5 degrees

bool has_sides(const LuminousOpening& opening) {
  return opening.shape != OpeningShape::point && opening.size_m().x > 0.0 &&
         opening.size_m().y > 0.0;
}

// The other one's outline along the axes of the first, from its centre.
struct Seen {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
  double above_m = 0.0;
};

Seen seen_from(const OpeningInPlace& first, const OpeningInPlace& other) {
  Seen seen;
  const glm::dvec3 half_m = 0.5 * other.opening.size_m();
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec3 corner_m = other.position_m + x * half_m.x * other.axes[0] +
                                  y * half_m.y * other.axes[1] - first.position_m;
      const glm::dvec2 at(glm::dot(corner_m, first.axes[0]), glm::dot(corner_m, first.axes[1]));
      seen.low = glm::min(seen.low, at);
      seen.high = glm::max(seen.high, at);
    }
  }
  seen.above_m = std::abs(glm::dot(other.position_m - first.position_m, first.axes[2]));
  return seen;
}

double shortest_side_m(const OpeningInPlace& one) {
  return std::min(one.opening.size_m().x, one.opening.size_m().y);
}

bool touch(const OpeningInPlace& one, const OpeningInPlace& other) {
  if (!(std::abs(glm::dot(one.axes[2], other.axes[2])) >= kParallel)) return false;
  const double near_m = kOfSide * std::min(shortest_side_m(one), shortest_side_m(other));
  const Seen seen = seen_from(one, other);
  if (seen.above_m > near_m) return false;
  const glm::dvec2 half_m = 0.5 * glm::dvec2(one.opening.size_m());
  const glm::dvec2 apart_m = glm::max(seen.low - half_m, -half_m - seen.high);  // < 0: they overlap
  return std::max(apart_m.x, apart_m.y) <= near_m && std::min(apart_m.x, apart_m.y) < 0.0;
}

// Whether all are narrow, and nowhere so many side by side that they fill half of a square metre:
// lines that meet, as in a frame of light along the walls.
bool is_of_lines(const std::vector<std::size_t>& members,
                 std::span<const OpeningInPlace> openings) {
  constexpr double kSquare_m = 1.0, kMostFilled = 0.48;
  for (const std::size_t i : members) {
    if (shortest_side_m(openings[i]) > kWidestLine_m) return false;
    double filled_m2 = 0.0;
    for (const std::size_t k : members) {
      const Seen seen = seen_from(openings[i], openings[k]);
      const glm::dvec2 inside_m = glm::min(seen.high, glm::dvec2(0.5 * kSquare_m)) -
                                  glm::max(seen.low, glm::dvec2(-0.5 * kSquare_m));
      if (inside_m.x > 0.0 && inside_m.y > 0.0) filled_m2 += inside_m.x * inside_m.y;
    }
    if (filled_m2 > kMostFilled * kSquare_m * kSquare_m) return false;
  }
  return true;
}

// As seen along the axes of a luminaire; corners in order.
using Outline = std::vector<glm::dvec2>;

// Floodlights of a mast stand at one place and look this little apart at least. What looks up or
// down is no such.
bool look_alike(const glm::dvec3& a, const glm::dvec3& b) {
  constexpr double kOneDegree = 0.99985, kSteep = 0.9962;  // cosines of 1 and 5 degrees
  if (std::abs(a.z) > kSteep && std::abs(b.z) > kSteep) return a.z * b.z > 0.0;
  return glm::dot(a, b) > kOneDegree;
}

Outline outline_of(const OpeningInPlace& opening, const OpeningInPlace& seen_from) {
  const bool is_round = opening.opening.shape == OpeningShape::disk ||
                        opening.opening.shape == OpeningShape::cylinder ||
                        opening.opening.shape == OpeningShape::ellipsoid;
  const double share = is_round ? std::sqrt(kPi) / 4.0 : 0.5;
  const glm::dvec3 size_m = opening.opening.size_m();
  const glm::dvec3 u = share * size_m.x * opening.axes[0], v = share * size_m.y * opening.axes[1];
  Outline corners;
  for (const glm::dvec3& way : {-u - v, u - v, u + v, v - u}) {
    const glm::dvec3 at = opening.position_m + way - seen_from.position_m;
    corners.emplace_back(glm::dot(at, seen_from.axes[0]), glm::dot(at, seen_from.axes[1]));
  }
  return corners;
}

// What of a convex outline lies in another one that turns left (Sutherland and Hodgman 1974).
Outline clipped(Outline outline, const Outline& by) {
  for (std::size_t k = 0; k < by.size() && !outline.empty(); ++k) {
    const glm::dvec2 from = by[k], along = by[(k + 1) % by.size()] - from;
    const auto side = [&](const glm::dvec2& p) {
      return along.x * (p.y - from.y) - along.y * (p.x - from.x);
    };
    Outline rest;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 p = outline[i], q = outline[(i + 1) % outline.size()];
      const double at_p = side(p), at_q = side(q);
      if (at_p >= 0.0) rest.push_back(p);
      if ((at_p >= 0.0) != (at_q >= 0.0)) rest.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    outline = std::move(rest);
  }
  return outline;
}

}  // namespace

std::vector<JoinedOpening> joined_openings(std::span<const OpeningInPlace> openings) {
  std::vector<std::size_t> group(openings.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  // Along x, so that only near ones are looked at.
  std::vector<std::size_t> order = group;
  const auto reach_m = [&](std::size_t i) {
    return (0.5 + kOfSide) * glm::length(openings[i].opening.size_m());
  };
  double most_m = 0.0;
  for (std::size_t i = 0; i < openings.size(); ++i) most_m = std::max(most_m, reach_m(i));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return openings[a].position_m.x < openings[b].position_m.x;
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const OpeningInPlace& one = openings[order[k]];
    if (!has_sides(one.opening)) continue;
    for (std::size_t n = k + 1; n < order.size(); ++n) {
      const OpeningInPlace& other = openings[order[n]];
      if (other.position_m.x - one.position_m.x > reach_m(order[k]) + most_m) break;
      if (!has_sides(other.opening) || !touch(one, other)) continue;
      const std::size_t a = root(order[k]), b = root(order[n]);
      group[std::max(a, b)] = std::min(a, b);
    }
  }
  std::map<std::size_t, JoinedOpening> joined;
  for (std::size_t i = 0; i < openings.size(); ++i) joined[root(i)].members.push_back(i);
  std::vector<JoinedOpening> found;
  for (auto& [first, one] : joined) {
    if (one.members.size() < 2) continue;
    Seen all;
    for (const std::size_t i : one.members) {
      const Seen seen = seen_from(openings[first], openings[i]);
      all.low = glm::min(all.low, seen.low);
      all.high = glm::max(all.high, seen.high);
    }
    one.width_m = std::min(all.high.x - all.low.x, all.high.y - all.low.y);
    if (one.width_m > kWidestLine_m && !is_of_lines(one.members, openings)) {
      found.push_back(std::move(one));
    }
  }
  return found;
}

double overlap_share(const OpeningInPlace& a, const OpeningInPlace& b) {
  if (!look_alike(a.axes[2], b.axes[2])) return 0.0;
  if (std::abs(glm::dot(b.position_m - a.position_m, a.axes[2])) > kOneBehind_m) return 0.0;
  const Outline one = outline_of(a, a);
  Outline other = outline_of(b, a);
  if (signed_area(other) < 0.0) std::reverse(other.begin(), other.end());
  const double smaller_m2 = std::min(signed_area(one), signed_area(other));
  if (!(smaller_m2 > 0.0)) return 0.0;
  const Outline both = clipped(other, one);
  return both.size() < 3 ? 0.0 : std::min(1.0, signed_area(both) / smaller_m2);
}

}  // namespace calc
