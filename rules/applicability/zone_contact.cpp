#include "rules/applicability/zone_contact.h"

#include "calc/scene/polygon.h"
#include "calc/scene/walking_surface.h"
#include "rules/applicability/place_in_space.h"

#include <algorithm>
#include <limits>
#include <variant>
#include <vector>

namespace rules {
namespace {

// Returns some places spread over the plane, because bodies may have a million triangles.
std::vector<glm::dvec3> some_places(const calc::SensorGrid& points) {
  constexpr std::size_t kPlaces = 25;
  const std::size_t all = points.position_m.size(), count = std::min(all, kPlaces);
  std::vector<glm::dvec3> places;
  for (std::size_t k = 0; k < count; ++k) {
    places.push_back(points.position_m[(2 * k + 1) * all / (2 * count)]);
  }
  return places;
}

struct Box {
  glm::dvec3 low_m{std::numeric_limits<double>::infinity()};
  glm::dvec3 high_m{-std::numeric_limits<double>::infinity()};

  bool is_over(const glm::dvec2& at) const {
    return at.x >= low_m.x && at.y >= low_m.y && at.x <= high_m.x && at.y <= high_m.y;
  }
};

Box box_of(const calc::Body& body) {
  Box box;
  for (const glm::dvec3& vertex : body.vertex_m) {
    box.low_m = glm::min(box.low_m, vertex);
    box.high_m = glm::max(box.high_m, vertex);
  }
  return box;
}

// Returns the highest surface of the body that is not above the place; -infinity: there is none.
double top_below_m(const calc::Body& body, const glm::dvec3& place) {
  double top_m = -std::numeric_limits<double>::infinity();
  for (const glm::uvec3& triangle : body.triangle) {
    const std::optional<double> z = calc::height_at(corners_of(body, triangle), glm::dvec2(place));
    if (z && *z <= place.z) top_m = std::max(top_m, *z);
  }
  return top_m;
}

}  // namespace

ZoneContact contact_with(const calc::CalcPlane& zone, const calc::SensorGrid& points) {
  ZoneContact contact{0, std::numeric_limits<double>::infinity()};
  const auto* area = std::get_if<calc::PlanarArea>(&zone.area);
  if (area == nullptr) return contact;
  for (const glm::dvec3& place : points.position_m) {
    const glm::dvec3 offset_m = place - area->origin_m;
    const glm::dvec2 flat(glm::dot(offset_m, area->u), glm::dot(offset_m, area->v));
    const double edge_m = calc::distance_to_boundary(area->outline_m, flat);
    const bool is_inside = calc::contains_point(area->outline_m, flat);
    contact.inside += is_inside && edge_m > kLift_m ? 1 : 0;
    contact.nearest_m = std::min(contact.nearest_m, is_inside ? 0.0 : edge_m);
  }
  return contact;
}

std::optional<Platform> platform_below(const calc::CalcPlane& plane, const calc::SensorGrid& points,
                                       const calc::Space& space) {
  constexpr double kStep_m = 0.1;   // lower things are doormats
  constexpr double kDesk_m = 0.25;  // below a task, what it lies on
  constexpr double kMost = 0.5;     // of the places
  if (!space.shell || points.position_m.empty()) return std::nullopt;
  const double floor_m = space.shell->floor_z_m;
  const std::vector<glm::dvec3> places = some_places(points);
  for (const calc::Body& body : space.bodies) {
    if (body.id == plane.id || is_part(body.id, ".floor")) continue;
    const Box box = box_of(body);
    if (box.high_m.z < floor_m + kStep_m) continue;
    std::size_t above = 0;
    double highest_m = 0.0;
    for (const glm::dvec3& place : places) {
      if (!box.is_over(glm::dvec2(place)) || box.low_m.z > place.z) continue;
      const double top_m = top_below_m(body, place);
      if (top_m < floor_m + kStep_m || top_m > place.z - kDesk_m) continue;
      ++above;
      highest_m = std::max(highest_m, top_m - floor_m);
    }
    if (static_cast<double>(above) > kMost * static_cast<double>(places.size())) {
      return Platform{body.id, highest_m};
    }
  }
  return std::nullopt;
}

}  // namespace rules
