#pragma once
// Finds closed bodies and the places inside them.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace calc {

// An axis-aligned box; by default it is empty (lower > upper).
struct BoundingBox {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return lower.x > upper.x; }
  void add(const glm::dvec3& point);
  // Returns whether the point is inside or on a face.
  bool contains(const glm::dvec3& point) const;
  glm::dvec3 centre() const { return is_empty() ? glm::dvec3(0.0) : 0.5 * (lower + upper); }
  // Returns the length of the diagonal; 0 if empty.
  double diagonal() const { return is_empty() ? 0.0 : glm::length(upper - lower); }
};

BoundingBox bounding_box(const std::vector<glm::dvec3>& points);

// Returns for each vertex the lowest index with exactly the same position.
std::vector<std::uint32_t> weld_vertices(const std::vector<glm::dvec3>& vertex);

// Returns whether the even-odd rule gives every point off the surface the same answer for any ray:
// each edge belongs to an even number of triangles, where corners at exactly the same position are
// the same and triangles with two equal corners do not count. The winding of triangles does not
// matter, because files often have it wrong and light is computed for both sides. False without
// triangles.
bool is_watertight(const Body& body);

enum class SolidSide { outside, on_surface, inside };

// Returns on which side of a watertight body a point is; `box` is the body's bounding box. On the
// surface means within 1e-9 of the box's diagonal (plus the rounding of the coordinates).
// O(triangles), but O(1) for points outside the box.
SolidSide locate_point(const Body& body, const BoundingBox& box, const glm::dvec3& point);

// Does the same for many points of one body, which must outlive it: a grid of columns finds the
// triangles over a point.
class SolidLocator {
 public:
  explicit SolidLocator(const Body& body);
  SolidSide locate(const glm::dvec3& point) const;

 private:
  std::size_t column(double along, std::size_t axis) const;

  const Body& body_;
  BoundingBox box_;
  double gap_;
  std::size_t columns_ = 1;  // along x and along y
  // Triangles over or within gap_ of a column, column by column.
  std::vector<std::uint32_t> triangle_;
  std::vector<std::size_t> begin_;  // columns_ * columns_ + 1
};

}  // namespace calc
