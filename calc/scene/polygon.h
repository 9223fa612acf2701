#pragma once
// Plane polygons in double. Nothing here depends on the unit: lengths below kPolygonTolerance times
// the diagonal of the polygon's bounding box (plus the rounding of its coordinates, for models far
// from the origin) count as zero. Corners are in order, the first is not repeated at the end.
// O(n^2), meant for up to some thousand corners.

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace calc {

inline constexpr double kPolygonTolerance = 1.0e-9;
// A polygon in space is planar when no corner is farther from its plane than this times its size.
inline constexpr double kPlanarTolerance = 1.0e-6;

// Returns the length that counts as zero among these corners.
double polygon_gap(const std::vector<glm::dvec2>& polygon);
double polygon_gap(const std::vector<glm::dvec3>& polygon);

// Returns whether it has at least 3 corners, all finite, area not zero, no two sides crossing,
// touching or on each other. Corners in the middle of a straight side are fine; equal corners and
// spikes are not.
bool is_simple_polygon(const std::vector<glm::dvec2>& polygon);

// Returns the shoelace area, > 0 for counter-clockwise corners; 0 for fewer than 3 corners.
double signed_area(const std::vector<glm::dvec2>& polygon);

// Returns whether the point is inside; the boundary, within the tolerance, counts as inside.
// Even-odd rule for polygons that are not simple; false for fewer than 3 corners.
bool contains_point(const std::vector<glm::dvec2>& polygon, glm::dvec2 point);

// Returns the distance to the nearest side, >= 0, from inside or outside; infinite if empty.
double distance_to_boundary(const std::vector<glm::dvec2>& polygon, glm::dvec2 point);

// Returns triangles by ear clipping, as indices into `polygon`; they wind as the polygon does and
// use every corner: n - 2 of them, none with zero area. Empty if the polygon is not simple.
std::optional<std::vector<glm::uvec3>> triangulate_polygon(const std::vector<glm::dvec2>& polygon);

// Returns the same in the polygon's own plane. Empty for non-planar, self-crossing, fewer than 3
// corners, zero area or a coordinate that is not finite.
std::optional<std::vector<glm::uvec3>> triangulate_polygon(const std::vector<glm::dvec3>& corners);

// The corners projected along the polygon's mean normal (Newell's method), counter-clockwise.
struct FlatPolygon {
  std::vector<glm::dvec2> corner;
  double deviation = 0.0;  // largest distance of a corner from the mean plane / size; >= 0
};
// Returns empty for fewer than 3 corners, zero area or a coordinate that is not finite.
std::optional<FlatPolygon> flatten_polygon(const std::vector<glm::dvec3>& corners);

}  // namespace calc
