#pragma once
// Repairs outlines with doubled corners, spikes, or holes joined to them by a way there and back;
// no other code does. The removed parts enclose nothing: the area and the direction of the outline
// stay. Where more than one area is possible (crossing sides) nothing is repaired.

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// A polygon bent up to this share of its size counts as flat with rounded numbers.
inline constexpr double kNearlyPlanar = 1.0e-3;

// The faults of one polygon, or several. Lengths in the polygon's unit.
struct Mending {
  std::size_t doubled = 0;  // corners at the place of the one before them
  std::size_t spikes = 0;   // corners at which the outline turns back on itself
  std::size_t joints = 0;   // holes or parts joined by a doubled side, or touching
  double longest = 0.0;     // of spikes and doubled sides
  glm::dvec3 at{0.0};       // where the longest is (its tip), or the first of what has no length

  bool is_any() const { return doubled + spikes + joints > 0; }
  void add(const Mending& other);
  // Returns "2 doubled corners, 1 spike and 1 joint of a hole or part".
  std::string words() const;
};

struct MendedPolygon {
  // Simple outlines, the first corner not repeated, indices into the given corners; one unless
  // there are joints. Parts come first and turn as the given polygon does, holes the other way.
  std::vector<std::vector<std::uint32_t>> ring;
  // Indices into the given corners; they turn as the polygon does and fill it.
  std::vector<glm::uvec3> triangle;
  Mending mending;
  double deviation = 0.0;  // largest distance of a corner from the mean plane / size; 0 in a plane
};

// Returns the repaired polygon; lengths that count as zero are those of polygon.h. A simple polygon
// is returned unchanged, with the triangles of triangulate_polygon(). Empty if sides cross, an area
// is enclosed twice, fewer than three corners are left, no area, or not finite. O(n^2) for simple
// ones, else O(n^2 log n).
std::optional<MendedPolygon> mend_polygon(const std::vector<glm::dvec2>& polygon);
// Returns the same along the mean plane of the corners left without doubled ones and spikes,
// however bent it is: callers check `deviation`.
std::optional<MendedPolygon> mend_polygon(const std::vector<glm::dvec3>& polygon);

// Removes corners that no triangle uses from the list; the others keep their order.
void drop_unused_corners(std::vector<glm::dvec3>& corner, std::vector<glm::uvec3>& triangle);

// Returns the area inside, >= 0, by the even-odd rule, sides may cross; 0 below 3 corners.
double enclosed_area(const std::vector<glm::dvec2>& polygon);
// Returns the same along the mean plane; 0 where there is none.
double enclosed_area(const std::vector<glm::dvec3>& polygon);

}  // namespace calc
