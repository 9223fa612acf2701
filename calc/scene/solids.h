#pragma once
// Closed bodies: which bodies have an inside, and what is in it.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace calc {

// Axis-aligned; default-made it is empty (lower > upper).
struct BoundingBox {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return lower.x > upper.x; }
  void add(const glm::dvec3& point);
  // Faces count as inside.
  bool contains(const glm::dvec3& point) const;
  glm::dvec3 centre() const { return is_empty() ? glm::dvec3(0.0) : 0.5 * (lower + upper); }
  // Length of the diagonal; 0 if empty.
  double diagonal() const { return is_empty() ? 0.0 : glm::length(upper - lower); }
};

BoundingBox bounding_box(const std::vector<glm::dvec3>& points);

// Number of each vertex's position: the lowest index that has exactly the same one.
std::vector<std::uint32_t> weld_vertices(const std::vector<glm::dvec3>& vertex);

// True when the even-odd rule gives every point off the surface one answer, whatever the ray: each
// edge belongs to an even number of triangles, corners at exactly the same position counting as one
// and triangles with two equal corners left out. Which way the triangles turn does not matter:
// files often have it wrong, and light is computed for both sides. False without triangles.
bool is_watertight(const Body& body);

enum class SolidSide { outside, on_surface, inside };

// Where a point is for a watertight body; `box` is the body's bounding box. On the surface means
// within 1e-9 of the box's diagonal (plus the rounding of the coordinates). O(triangles), but O(1)
// for points outside the box.
SolidSide locate_point(const Body& body, const BoundingBox& box, const glm::dvec3& point);

// The same for many points of one body, which must outlive it: what stands over a point is found in
// a grid of columns.
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
  // Triangles over or within gap_ of a column, one column behind the other.
  std::vector<std::uint32_t> triangle_;
  std::vector<std::size_t> begin_;  // columns_ * columns_ + 1
};

}  // namespace calc
