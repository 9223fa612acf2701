#pragma once
// Points on all triangles of a body around the origin, for means over its whole inside.

#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace test_support {

struct FacetGrid {
  calc::SensorGrid grid;
  std::vector<double> area_m2;  // weight of each point
};

// Six points per facet, facing inwards: exact for polynomials of degree 4.  [Dunavant 1985]
inline FacetGrid facet_grid(const calc::PreparedScene& scene) {
  constexpr double kWeight[2] = {0.223381589678011, 0.109951743655322};
  constexpr double kApex[2] = {0.108103018168070, 0.816847572980459};
  FacetGrid facets;
  for (const glm::uvec3& t : scene.triangle) {
    const std::array<glm::dvec3, 3> p{scene.vertex_m[t.x], scene.vertex_m[t.y],
                                      scene.vertex_m[t.z]};
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    for (std::size_t ring = 0; ring < 2; ++ring) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double rest = 0.5 * (1.0 - kApex[ring]);
        facets.grid.position_m.push_back(kApex[ring] * p[k] +
                                         rest * (p[(k + 1) % 3] + p[(k + 2) % 3]));
        facets.grid.normal.push_back(
            glm::normalize(glm::dot(normal, p[0]) > 0.0 ? -normal : normal));
        facets.area_m2.push_back(0.5 * glm::length(normal) * kWeight[ring]);
      }
    }
  }
  return facets;
}

// Of the total illuminance, weighted by area; 99.9 % interval from the replicates.
inline calc::Estimate facet_mean(const FacetGrid& facets, const calc::PlaneField& field) {
  double area_m2 = 0.0;
  for (const double of_point : facets.area_m2) area_m2 += of_point;
  std::vector<double> means(field.replicates, 0.0);
  for (std::size_t r = 0; r < field.replicates; ++r) {
    for (std::size_t i = 0; i < field.points; ++i) {
      means[r] += facets.area_m2[i] * total_lx(field, r, i);
    }
    means[r] /= area_m2;
  }
  return calc::t_interval(means, 0.999);
}

}  // namespace test_support
