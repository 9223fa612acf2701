#pragma once
// Finds the triangles of a space near a place.

#include "calc/base/triangle.h"
#include "calc/scene/project.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// A triangle, world coordinates, and the body that it belongs to.
struct BodyTriangle {
  Triangle corner_m;
  const Body* body = nullptr;
};

// Triangles in the cells of a grid over a region.
class NearTriangles {
 public:
  // Holds the triangles of the space's bodies, which must outlive it; for places within the region
  // and radii up to most_m.
  NearTriangles(const Space& space, const BoundingBox& region, double most_m);

  // Returns all triangles no farther from the place than radius_m, in the order of the space,
  // without those that have no area.
  std::vector<BodyTriangle> within(const glm::dvec3& place_m, double radius_m) const;

 private:
  using Cell = std::array<std::size_t, 3>;

  void lay_cells();
  Cell cell_of(const glm::dvec3& place_m) const;
  std::size_t number(const Cell& cell) const;
  // Calls visit(cell number) for every cell that the triangle may reach.
  template <class Visit>
  void visit_cells(const Triangle& triangle, const Visit& visit) const;

  BoundingBox region_;  // with most_m around it
  double most_m_;
  double side_m_ = 1.0;  // of a cell
  Cell count_{1, 1, 1};
  std::vector<BodyTriangle> triangles_;
  std::vector<std::uint32_t> begin_;  // of each cell's part of listed_, and its end
  std::vector<std::uint32_t> listed_;
};

}  // namespace calc
