#include "rules/applicability/place_in_space.h"

#include "calc/project/spaces/plane_area.h"
#include "calc/scene/plane_place.h"
#include "calc/scene/walking_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>

namespace rules {
namespace {

// Cosine and sine of 15 degrees.
constexpr double kAlike = 0.966;
constexpr double kAcross = 0.259;

// Returns whether a point is in a triangle of the plane, edges included.
bool contains(const std::array<glm::dvec2, 3>& corner, const glm::dvec2& point) {
  const auto side = [&](int a, int b) {
    const glm::dvec2 edge =
        corner[static_cast<std::size_t>(b)] - corner[static_cast<std::size_t>(a)];
    const glm::dvec2 offset = point - corner[static_cast<std::size_t>(a)];
    return edge.x * offset.y - edge.y * offset.x;
  };
  const double d0 = side(0, 1), d1 = side(1, 2), d2 = side(2, 0);
  return (d0 >= 0.0 && d1 >= 0.0 && d2 >= 0.0) || (d0 <= 0.0 && d1 <= 0.0 && d2 <= 0.0);
}

struct Surfaces {
  double lowest_m, highest_m;
};

// Returns the surfaces of bodies below a place, or up to lift_m above it; empty: there is none.
std::optional<Surfaces> surfaces_below(const calc::Space& space, const glm::dvec3& place,
                                       double lift_m = kLift_m) {
  std::optional<Surfaces> found;
  for (const calc::Body& body : space.bodies) {
    for (const glm::uvec3& triangle : body.triangle) {
      const std::optional<double> z =
          calc::height_at(corners_of(body, triangle), glm::dvec2(place));
      if (!z || *z > place.z + lift_m) continue;
      if (!found) found = Surfaces{*z, *z};
      found = Surfaces{std::min(found->lowest_m, *z), std::max(found->highest_m, *z)};
    }
  }
  return found;
}

double surface_below_m(const calc::Space& space, const glm::dvec3& place) {
  const std::optional<Surfaces> found = surfaces_below(space, place);
  return found ? found->highest_m : 0.0;
}

double lowest_corner_m(const calc::Space& space) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const calc::Body& body : space.bodies) {
    for (const glm::dvec3& vertex : body.vertex_m) lowest = std::min(lowest, vertex.z);
  }
  return std::isfinite(lowest) ? lowest : 0.0;
}

// Returns whether the place is within off_m of the triangle and faces away from it on either side,
// within the angle with this sine. Sines are used because near 0 a cosine says little.
bool lies_on(const glm::dvec3& place, const glm::dvec3& normal,
             const std::array<glm::dvec3, 3>& corner, double off_m = kLift_m,
             double sine = kAcross) {
  const glm::dvec3 area = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double size = glm::length(area);
  if (!(size > 0.0)) return false;
  const glm::dvec3 face = area / size;
  if (glm::length(glm::cross(face, normal)) > sine) return false;
  if (std::abs(glm::dot(face, place - corner[0])) > off_m) return false;
  // Seen along its own normal, a little larger, so that edges do not matter.
  const glm::dvec3 middle = (corner[0] + corner[1] + corner[2]) / 3.0;
  const glm::dvec3 u = glm::normalize(corner[1] - corner[0]), v = glm::cross(face, u);
  const auto flat = [&](const glm::dvec3& p) {
    return glm::dvec2(glm::dot(p - middle, u), glm::dot(p - middle, v));
  };
  std::array<glm::dvec2, 3> seen{flat(corner[0]), flat(corner[1]), flat(corner[2])};
  for (glm::dvec2& p : seen) {
    const double distance = glm::length(p);
    if (distance > 0.0) p *= 1.0 + kLift_m / distance;
  }
  return contains(seen, flat(place));
}

}  // namespace

std::array<glm::dvec3, 3> corners_of(const calc::Body& body, const glm::uvec3& triangle) {
  return {body.vertex_m[triangle.x], body.vertex_m[triangle.y], body.vertex_m[triangle.z]};
}

bool is_part(std::string_view id, std::string_view part) {
  const std::size_t last = id.find_last_not_of("0123456789");
  return last != std::string_view::npos && id.substr(0, last + 1).ends_with(part);
}

bool looks_up(const glm::dvec3& normal) { return normal.z >= kAlike; }
bool looks_down(const glm::dvec3& normal) { return normal.z <= -kAlike; }
bool looks_sideways(const glm::dvec3& normal) { return std::abs(normal.z) <= kAcross; }

double height_above_floor_m(const glm::dvec3& place, const calc::Space& space) {
  if (space.shell) return place.z - space.shell->floor_z_m;
  const bool is_open = space.surfaces_file.empty();
  return place.z - (is_open ? surface_below_m(space, place) : lowest_corner_m(space));
}

std::vector<MountingHeight> mounting_heights_m(const calc::Space& space,
                                               const calc::CalcPlane& plane) {
  const bool is_route = std::holds_alternative<calc::EscapeRoute>(plane.area);
  std::vector<double> walked_m;  // of the plane
  for (const glm::dvec3& place : calc::places_of(plane)) {
    const std::optional<Surfaces> below =
        is_route ? Surfaces{place.z, place.z} : surfaces_below(space, place);
    if (below) walked_m.push_back(below->highest_m);
  }
  std::vector<MountingHeight> heights;
  for (const calc::Luminaire& luminaire : space.luminaires) {
    const glm::dvec3& place = luminaire.position_m;
    const double floor_m = place.z - height_above_floor_m(place, space);
    Surfaces walked{floor_m, floor_m};
    const auto add = [&](double z) {
      if (z > place.z - kLift_m) return;  // the ceiling that it is in
      walked = {std::min(walked.lowest_m, z), std::max(walked.highest_m, z)};
    };
    if (const std::optional<Surfaces> below = surfaces_below(space, place, -kLift_m)) {
      add(below->lowest_m);
      add(below->highest_m);
    }
    for (const double z : walked_m) add(z);
    heights.push_back({place.z - walked.highest_m, place.z - walked.lowest_m});
  }
  return heights;
}

double room_width_m(const calc::Space& space, double most_m) {
  const std::vector<glm::dvec2>& outline = space.shell ? space.shell->footprint_m : space.outline_m;
  return outline.size() < 3 ? most_m : calc::width_up_to(outline, most_m);
}

std::pair<double, double> heights_above_floor_m(const calc::CalcPlane& plane,
                                                const calc::Space& space) {
  if (const auto* route = std::get_if<calc::EscapeRoute>(&plane.area)) {
    return {route->height_m, route->height_m};
  }
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const glm::dvec3& place : calc::places_of(plane)) {
    const double height_m = height_above_floor_m(place, space);
    lowest = std::min(lowest, height_m);
    highest = std::max(highest, height_m);
  }
  return {lowest, highest};
}

bool lies_on(const calc::CalcPlane& plane, const calc::Space& space, std::string_view part) {
  const std::vector<glm::dvec3> places = calc::places_of(plane), normals = calc::normals_of(plane);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_found =
        std::any_of(space.bodies.begin(), space.bodies.end(), [&](const calc::Body& body) {
          return (!space.shell || is_part(body.id, part)) &&
                 std::any_of(body.triangle.begin(), body.triangle.end(),
                             [&](const glm::uvec3& triangle) {
                               return lies_on(places[i], normals[i], corners_of(body, triangle));
                             });
        });
    if (!is_found) return false;
  }
  return true;
}

bool lies_along(const calc::CalcPlane& plane, const calc::Space& space) {
  constexpr double kSine = 0.0087;  // half a degree
  const std::vector<glm::dvec3> places = calc::places_of(plane), normals = calc::normals_of(plane);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_found =
        std::any_of(space.bodies.begin(), space.bodies.end(), [&](const calc::Body& body) {
          return std::any_of(body.triangle.begin(), body.triangle.end(),
                             [&](const glm::uvec3& triangle) {
                               return lies_on(places[i], normals[i], corners_of(body, triangle),
                                              kOnSlope_m, kSine);
                             });
        });
    if (!is_found) return false;
  }
  return true;
}

const calc::Body* body_before(const calc::CalcPlane& plane, const calc::Space& space) {
  constexpr double kIn_m = 1.0e-5;  // what lies in a surface is measured before it
  const std::vector<glm::dvec3> places = calc::places_of(plane), normals = calc::normals_of(plane);
  for (const calc::Body& body : space.bodies) {
    bool is_before = !places.empty();
    for (std::size_t i = 0; is_before && i < places.size(); ++i) {
      is_before =
          std::any_of(body.triangle.begin(), body.triangle.end(), [&](const glm::uvec3& triangle) {
            const std::array<glm::dvec3, 3> corner = corners_of(body, triangle);
            return glm::dot(normals[i], corner[0] - places[i]) > kIn_m &&
                   lies_on(places[i], normals[i], corner);
          });
    }
    if (is_before) return &body;
  }
  return nullptr;
}

}  // namespace rules
