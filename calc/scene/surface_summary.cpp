#include "calc/scene/surface_summary.h"

#include <limits>

namespace calc {

SurfaceSummary summarise_surfaces(const PreparedScene& scene) {
  SurfaceSummary summary;
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-std::numeric_limits<double>::max());
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    const glm::uvec3 corner = scene.triangle[t];
    const glm::dvec3 a(scene.vertex_m[corner.x]);
    const glm::dvec3 b(scene.vertex_m[corner.y]);
    const glm::dvec3 c(scene.vertex_m[corner.z]);
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    summary.area_m2 += area;
    summary.mean_reflectance += area * scene.reflectance[t];
    low = glm::min(low, glm::min(a, glm::min(b, c)));
    high = glm::max(high, glm::max(a, glm::max(b, c)));
  }
  if (summary.area_m2 > 0.0) summary.mean_reflectance /= summary.area_m2;
  const glm::dvec3 size = glm::max(high - low, glm::dvec3(0.0));
  const double surface = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
  const double chord = surface > 0.0 ? 4.0 * size.x * size.y * size.z / surface : 0.0;
  summary.mean_free_path_m = chord > 1e-6 * scene.extent_m ? chord : scene.extent_m;
  return summary;
}

}  // namespace calc
