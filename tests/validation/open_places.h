#pragma once
// Points with areas over surfaces, for averages.

#include "report/tools/selftest/quadrature.h"
#include "report/tools/selftest/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace validation {

using Triangle = std::array<glm::dvec3, 3>;

// 4^levels parts of the same area.
std::vector<Triangle> split_triangle(const Triangle& whole, int levels);

struct Places {
  std::vector<cli::selftest::Point> point;
  std::vector<double> area_m2;  // of each

  double sum_m2() const;
  void add(const Places& more);
};

// Where light on a rectangle changes quickly: cells are at most `finest_m` plus half their distance
// from it along either side.
struct HotSpot {
  glm::dvec3 position_m;
  double finest_m;
};

// 4 x 4 Gauss points in cells that grow away from hot spots and, where edge_m > 0, from the edges,
// at which they are that large; along the edges themselves cells of rim_m with one point each.
Places places_on(const cli::selftest::Rectangle& rectangle, const std::vector<HotSpot>& hot,
                 double edge_m, double rim_m);
// A polygon that has no dent: 3 points in 4^levels parts of each of its triangles.
Places places_on_polygon(const std::vector<glm::dvec3>& corners, int levels);
// A disc: Gauss points along radius^2, evenly around.
Places places_on_disc(const glm::dvec3& centre_m, double radius_m, const glm::dvec3& normal,
                      int rings, int around);

}  // namespace validation
