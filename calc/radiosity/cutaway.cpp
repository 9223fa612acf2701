#include "calc/radiosity/cutaway.h"

#include "calc/radiosity/near_field.h"

#include <tbb/parallel_for.h>

#include <cstddef>

namespace calc {
namespace {

constexpr int kRays = 24;
constexpr double kClearDifference = 0.4;

// Share of rays that meet a surface, seen from the middle of a triangle.
double hit_share(const Tracer& tracer, const glm::dvec3& middle_m, const glm::dvec3& normal) {
  const glm::dvec3 origin_m = tracer.lift(middle_m, normal);
  int hits = 0;
  SurfaceHit hit;
  for (int k = 0; k < kRays; ++k) {
    const double golden = 0.618033988749895 * k;
    const glm::dvec3 direction =
        cosine_direction(normal, (k + 0.5) / kRays, golden - static_cast<int>(golden));
    if (tracer.closest_hit(origin_m, direction, 2.0 * tracer.scene().extent_m, hit)) ++hits;
  }
  return static_cast<double>(hits) / kRays;
}

}  // namespace

Cutaway cut_away(const Tracer& tracer, const glm::dvec3& eye_m, bool opens_room) {
  const PreparedScene& scene = tracer.scene();
  std::vector<SurfaceSide> side(scene.triangle.size());
  std::vector<std::uint8_t> is_removed(scene.triangle.size(), 0);
  tbb::parallel_for(std::size_t{0}, side.size(), [&](std::size_t t) {
    const FlushDenormals flush;
    const glm::uvec3& corner = scene.triangle[t];
    const glm::dvec3 a(scene.vertex_m[corner.x]), b(scene.vertex_m[corner.y]),
        c(scene.vertex_m[corner.z]);
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const bool is_flipped = glm::dot(normal, eye_m - a) < 0.0;
    const glm::dvec3 near_normal = is_flipped ? -normal : normal;
    side[t] = {static_cast<std::uint32_t>(t), is_flipped, glm::vec3(near_normal)};
    if (!opens_room) return;
    const glm::dvec3 middle_m = (a + b + c) / 3.0;
    const double far_share = hit_share(tracer, middle_m, -near_normal);
    if (far_share < kClearDifference) return;
    const double near_share = hit_share(tracer, middle_m, near_normal);
    if (far_share - near_share >= kClearDifference) is_removed[t] = 1;
  });
  Cutaway result;
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (is_removed[t] != 0) {
      result.removed.push_back(static_cast<std::uint32_t>(t));
    } else {
      result.shown.push_back(side[t]);
    }
  }
  return result;
}

}  // namespace calc
