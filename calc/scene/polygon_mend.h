#pragma once
// The one home of mending: outlines that somebody drew with corners twice, spikes, or holes joined
// to them by a way there and back. What is taken out encloses nothing: the area and the direction
// of the outline stay. Where more than one area could be meant (sides that cross) nothing is
// mended.

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// A bent polygon up to this, of its size, is taken for a flat one of rounded numbers.
inline constexpr double kNearlyPlanar = 1.0e-3;

// What was wrong with one polygon, or several. Lengths in the polygon's unit.
struct Mending {
  std::size_t doubled = 0;  // corners at the place of the one before them
  std::size_t spikes = 0;   // corners at which the outline turns back on itself
  std::size_t joints = 0;   // holes or parts joined by a doubled side, or touching
  double longest = 0.0;     // of spikes and doubled sides
  glm::dvec3 at{0.0};       // where the longest is (its tip), or the first of what has no length

  bool is_any() const { return doubled + spikes + joints > 0; }
  void add(const Mending& other);
  // "2 doubled corners, 1 spike and 1 joint of a hole or part"
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

// Lengths that count as zero are those of polygon.h. A simple polygon comes back as it is, with the
// triangles of triangulate_polygon(). Empty if sides cross, an area is enclosed twice, fewer than
// three corners are left, no area, or not finite. O(n^2) for simple ones, else O(n^2 log n).
std::optional<MendedPolygon> mend_polygon(const std::vector<glm::dvec2>& polygon);
// Along the mean plane of what is left without doubled corners and spikes, however bent it is:
// callers look at `deviation`.
std::optional<MendedPolygon> mend_polygon(const std::vector<glm::dvec3>& polygon);

// Takes corners that no triangle has out of the list; those that are left keep their order.
void drop_unused_corners(std::vector<glm::dvec3>& corner, std::vector<glm::uvec3>& triangle);

// Of what lies inside by the even-odd rule, sides may cross; >= 0. 0 for fewer than 3 corners.
double enclosed_area(const std::vector<glm::dvec2>& polygon);
// The same along the mean plane; 0 where there is none.
double enclosed_area(const std::vector<glm::dvec3>& polygon);

}  // namespace calc
