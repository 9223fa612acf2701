#include "rules/applicability/room_border.h"

#include "calc/scene/polygon.h"
#include "rules/applicability/place_in_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace rules {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kStep_m = 0.1;  // between places on the outline
constexpr int kMostSteps = 400;  // of a side
constexpr double kAbove_m = 0.1;
constexpr double kBesideWalls = 0.8;  // of the outline of a room without known walls

std::vector<glm::dvec2> places_on_outline(const calc::PlanarArea& area) {
  std::vector<glm::dvec2> places;
  const std::size_t corners = area.outline_m.size();
  const auto in_world = [&](const glm::dvec2& flat) {
    return glm::dvec2(area.origin_m + flat.x * area.u + flat.y * area.v);
  };
  for (std::size_t i = 0; i < corners; ++i) {
    const glm::dvec2 from = in_world(area.outline_m[i]);
    const glm::dvec2 to = in_world(area.outline_m[(i + 1) % corners]);
    const double steps = std::ceil(glm::length(to - from) / kStep_m);
    const int count = static_cast<int>(std::clamp(steps, 1.0, double{kMostSteps}));
    for (int k = 0; k < count; ++k) places.push_back(from + (k + 0.5) / count * (to - from));
  }
  return places;
}

using Segment = std::pair<glm::dvec2, glm::dvec2>;

double distance_m(const Segment& segment, const glm::dvec2& place) {
  const glm::dvec2 along = segment.second - segment.first;
  const double length2 = glm::dot(along, along);
  const double t =
      length2 > 0.0 ? std::clamp(glm::dot(place - segment.first, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(place - (segment.first + t * along));
}

// Returns where a triangle crosses a height; empty: it does not.
std::optional<Segment> slice(const std::array<glm::dvec3, 3>& corner, double z) {
  std::vector<glm::dvec2> crossings;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 a = corner[i], b = corner[(i + 1) % 3];
    if (a.z == b.z || (z - a.z) * (z - b.z) > 0.0) continue;
    crossings.push_back(glm::dvec2(a + (z - a.z) / (b.z - a.z) * (b - a)));
  }
  if (crossings.size() < 2) return std::nullopt;
  // A corner at this height is a crossing of both of its sides.
  return Segment{crossings.front(),
                 *std::max_element(crossings.begin(), crossings.end(),
                                   [&](const glm::dvec2& p, const glm::dvec2& q) {
                                     return glm::length(p - crossings.front()) <
                                            glm::length(q - crossings.front());
                                   })};
}

bool is_upright(const std::array<glm::dvec3, 3>& corner) {
  const glm::dvec3 area = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double size = glm::length(area);
  return size > 0.0 && looks_sideways(area / size);
}

std::vector<Segment> upright_at(const calc::Space& space, double z) {
  std::vector<Segment> segments;
  for (const calc::Body& body : space.bodies) {
    for (const glm::uvec3& triangle : body.triangle) {
      const auto corner = corners_of(body, triangle);
      if (!is_upright(corner)) continue;
      if (const auto segment = slice(corner, z)) segments.push_back(*segment);
    }
  }
  return segments;
}

double farthest_m(const std::vector<glm::dvec2>& room_m, const std::vector<glm::dvec2>& places) {
  double farthest = 0.0;
  for (const glm::dvec2& place : places) {
    if (!calc::contains_point(room_m, place)) continue;
    farthest = std::max(farthest, calc::distance_to_boundary(room_m, place));
  }
  return farthest;
}

}  // namespace

double distance_from_walls_m(const calc::PlanarArea& area, const calc::Space& space) {
  const std::vector<glm::dvec2> places = places_on_outline(area);
  const std::vector<glm::dvec2>& room_m = space.shell ? space.shell->footprint_m : space.outline_m;
  if (room_m.size() >= 3) return farthest_m(room_m, places);
  if (space.surfaces_file.empty() || places.empty()) return kInfinite;
  const std::vector<Segment> walls = upright_at(space, area.origin_m.z + kAbove_m);
  std::vector<double> distances;
  for (const glm::dvec2& place : places) {
    double nearest = kInfinite;
    for (const Segment& wall : walls) nearest = std::min(nearest, distance_m(wall, place));
    distances.push_back(nearest);
  }
  const auto last = static_cast<std::size_t>(kBesideWalls * static_cast<double>(places.size()));
  const auto at =
      distances.begin() + static_cast<std::ptrdiff_t>(std::min(last, places.size() - 1));
  std::nth_element(distances.begin(), at, distances.end());
  return *at;
}

}  // namespace rules
