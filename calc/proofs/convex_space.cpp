#include "calc/proofs/convex_space.h"

#include "calc/proofs/beam.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace calc {

// Builds walls, largest triangles first: those define a wall best, and the needles of a
// triangulation then fall into a wall that is known already.
struct ConvexSearch {
  using Wall = ConvexSpace::Wall;

  const PreparedScene& scene;
  ConvexSpace space;
  std::vector<glm::dvec3> corners;  // of all triangles and all openings
  std::size_t tests_left = kMostWallTests;

  glm::dvec3 corner(std::size_t triangle, int k) const {
    return glm::dvec3(scene.vertex_m[scene.triangle[triangle][k]]);
  }

  void add_corners() {
    std::vector<std::uint8_t> is_used(scene.vertex_m.size(), 0);
    for (const glm::uvec3& t : scene.triangle) is_used[t.x] = is_used[t.y] = is_used[t.z] = 1;
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      if (is_used[v] != 0) corners.emplace_back(scene.vertex_m[v]);
    }
    for (const PlacedLuminaire& luminaire : scene.luminaires) {
      const glm::dvec3 half_m = 0.5 * luminaire.opening.size_m();
      for (int k = 0; k < 8; ++k) {
        const glm::dvec3 side((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0,
                              (k & 4) != 0 ? 1.0 : -1.0);
        corners.push_back(luminaire.position_m + luminaire.world_from_luminaire * (side * half_m));
      }
    }
  }

  std::vector<std::size_t> triangles_by_size() const {
    std::vector<double> area(scene.triangle.size());
    for (std::size_t t = 0; t < area.size(); ++t) {
      area[t] = glm::length(glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)));
    }
    std::vector<std::size_t> order(area.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
    return order;
  }

  bool lies_in(const Wall& wall, std::size_t triangle) const {
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(glm::dot(wall.outward, corner(triangle, k)) - wall.distance_m) <=
            space.tolerance_m_))
        return false;
    }
    return true;
  }

  // The triangle's plane with everything on its inner side; none if something lies on either side,
  // or nothing on any.
  std::optional<Wall> wall_through(std::size_t triangle) const {
    const glm::dvec3 a = corner(triangle, 0);
    const glm::dvec3 normal =
        glm::normalize(glm::cross(corner(triangle, 1) - a, corner(triangle, 2) - a));
    const double distance_m = glm::dot(normal, a);
    bool is_any_in_front = false, is_any_behind = false;
    for (const glm::dvec3& c : corners) {
      const double height_m = glm::dot(normal, c) - distance_m;
      if (!(height_m <= space.tolerance_m_)) is_any_in_front = true;
      if (!(height_m >= -space.tolerance_m_)) is_any_behind = true;
      if (is_any_in_front && is_any_behind) return std::nullopt;
    }
    if (is_any_in_front) return Wall{-normal, -distance_m};
    if (is_any_behind) return Wall{normal, distance_m};
    return std::nullopt;
  }

  // Shadow rays end off the opening, along the luminaire's axis towards the receiver, or off a
  // luminous body's surface. Across a wall
  // they would end only at a tilted luminaire in it: one that lies flat in the wall is lifted
  // outward only for receivers outside.
  bool keeps_off(const PlacedLuminaire& luminaire, const Wall& wall) const {
    const bool is_body = luminaire.opening.is_body();
    const double along_axis = std::abs(glm::dot(wall.outward, luminaire.world_from_luminaire[2]));
    const double lift_m = space.offset_m_ * (is_body ? 1.0 : along_axis);
    const double highest_m =
        glm::dot(wall.outward, luminaire.position_m) + opening_support_m(luminaire, wall.outward);
    const bool is_flat = !is_body && glm::length(glm::cross(
                                         wall.outward, luminaire.world_from_luminaire[2])) < 1.0e-6;
    return is_flat || highest_m + lift_m <= wall.distance_m + space.tolerance_m_;
  }

  static ConvexAnswer not_proved(std::string why, std::optional<std::uint32_t> body = {}) {
    return {std::nullopt, std::move(why), body};
  }

  ConvexAnswer run() {
    space.offset_m_ = scene.ray_offset_m();
    space.tolerance_m_ = 0.25 * space.offset_m_;
    if (scene.triangle.size() > kMostConvexTriangles) {
      return not_proved("there are too many surfaces to look for a proof");
    }
    add_corners();
    for (const std::size_t t : triangles_by_size()) {
      const std::size_t tests = space.walls_.size() + corners.size();
      if (tests_left < tests || space.walls_.size() == kMostWalls) {
        return not_proved("there are too many different walls to look for a proof");
      }
      tests_left -= tests;
      if (std::any_of(space.walls_.begin(), space.walls_.end(),
                      [&](const Wall& wall) { return lies_in(wall, t); }))
        continue;
      const std::optional<Wall> wall = wall_through(t);
      if (!wall) {
        return not_proved("surfaces or luminaires lie on both sides of a surface", scene.body[t]);
      }
      for (const PlacedLuminaire& luminaire : scene.luminaires) {
        if (!keeps_off(luminaire, *wall)) {
          return not_proved("a tilted luminaire touches a wall", scene.body[t]);
        }
      }
      space.walls_.push_back(*wall);
    }
    return {std::move(space), "", std::nullopt};
  }
};

// normal: 0 = any way.
bool ConvexSpace::holds_lifted(const glm::dvec3& position_m, const glm::dvec3& normal) const {
  const bool is_any = normal == glm::dvec3(0.0);
  return std::all_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
    const double height_m = glm::dot(wall.outward, position_m) - wall.distance_m;
    const double cosine = is_any ? 1.0 : glm::dot(wall.outward, normal);
    const double lift_m = offset_m_ * std::max(0.0, cosine);
    return height_m + lift_m <= tolerance_m_;
  });
}

bool ConvexSpace::holds(const PointSet& points, const PointBounds& bounds) const {
  // The box, lifted any way, inside: all points inside. Enough for planes off the walls.
  const bool is_box_inside = std::all_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
    return std::all_of(bounds.corner_m.begin(), bounds.corner_m.end(), [&](const glm::dvec3& c) {
      return glm::dot(wall.outward, c) + offset_m_ <= wall.distance_m + tolerance_m_;
    });
  });
  if (is_box_inside) return true;
  const std::size_t count = points.position_m.size();
  if (walls_.size() > kMostWallTests / count) return false;
  // A semicylindrical point in a surface is lifted across its axis, to the side that its plane has.
  const bool is_any_lift = points.kernel == ReceiverKernel::semicylindrical;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 lift = is_any_lift ? glm::dvec3(0.0) : points.normal[i];
    if (!holds_lifted(points.position_m[i], lift)) return false;
  }
  return true;
}

ConvexAnswer find_convex_space(const PreparedScene& scene) {
  ConvexSearch search{scene, {}, {}};
  return search.run();
}

}  // namespace calc
