#pragma once
// Proves that nothing can be between two points of a space.

#include "calc/proofs/point_set.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// Proof of V = 1. Every triangle is in one of `walls` (within a tolerance), and every corner of
// every triangle, every luminaire and every tested point is on the inner side of every wall or in
// it. Both ends of a segment between such points are then on one side of the plane of any triangle,
// so that the segment does not pass through that plane: it can touch a surface at its ends or run
// within it, and a surface that holds an end hides nothing from it. This includes the space between
// flat ground and luminaires above it. The tolerance is a quarter of ray_offset_m(), at least 8 ulp
// of the largest coordinate: corners of a flat wall rounded to float are within it, and rays, which
// start a whole ray_offset_m() off surfaces, do not see it. Beside an edge of less than 90 degrees
// a ray that starts within ray_offset_m() of the edge may start behind the other wall, where it
// would count as blocked; not tracing it is more accurate.
class ConvexSpace {
 public:
  // Returns whether the points, and their lifted ray origins, are inside as well.
  bool holds(const PointSet& points, const PointBounds& bounds) const;

 private:
  friend struct ConvexSearch;
  struct Wall {
    glm::dvec3 outward;  // unit
    double distance_m;   // inside: dot(outward, p) <= distance_m
  };
  bool holds_lifted(const glm::dvec3& position_m, const glm::dvec3& normal) const;

  std::vector<Wall> walls_;
  double offset_m_ = 0.0, tolerance_m_ = 0.0;
};

struct ConvexAnswer {
  std::optional<ConvexSpace> space;
  std::string why_not;                         // a clause: "surfaces stand inside"
  std::optional<std::uint32_t> obstacle_body;  // a body with a surface that stands inside
};

// The limits of walls, triangles and comparisons, beyond which the search ends ("not proved").
inline constexpr std::size_t kMostWalls = 2000;
inline constexpr std::size_t kMostConvexTriangles = 20'000;
inline constexpr std::size_t kMostWallTests = 20'000'000;

ConvexAnswer find_convex_space(const PreparedScene& scene);

}  // namespace calc
