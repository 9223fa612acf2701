#include "calc/radiosity/looks/cutaway.h"

#include "calc/radiosity/paths/near_field.h"

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
    if (tracer.closest_hit(origin_m, direction, 2.0 * tracer.scene().whole_extent_m(), hit)) ++hits;
  }
  return static_cast<double>(hits) / kRays;
}

struct Sides {
  glm::dvec3 corner_m, middle_m, normal;  // counter-clockwise seen from where the normal points
};

Sides sides_of(const PreparedScene& scene, std::size_t triangle) {
  const glm::uvec3& corner = scene.triangle[triangle];
  const glm::dvec3 a(scene.vertex_m[corner.x]), b(scene.vertex_m[corner.y]),
      c(scene.vertex_m[corner.z]);
  return {a, (a + b + c) / 3.0, glm::normalize(glm::cross(b - a, c - a))};
}

// Whether the near side of a triangle is the outside of a room. normal: towards the near side.
bool is_outside(const Tracer& tracer, const glm::dvec3& middle_m, const glm::dvec3& normal) {
  const double far_share = hit_share(tracer, middle_m, -normal);
  return far_share >= kClearDifference &&
         far_share - hit_share(tracer, middle_m, normal) >= kClearDifference;
}

}  // namespace

Cutaway cut_away(const Tracer& tracer, const glm::dvec3& eye_m, bool opens_room) {
  const PreparedScene& scene = tracer.scene();
  std::vector<SurfaceSide> side(scene.triangle.size());
  std::vector<std::uint8_t> is_removed(scene.triangle.size(), 0);
  tbb::parallel_for(std::size_t{0}, side.size(), [&](std::size_t t) {
    const FlushDenormals flush;
    const Sides both = sides_of(scene, t);
    const bool is_flipped = glm::dot(both.normal, eye_m - both.corner_m) < 0.0;
    const glm::dvec3 normal = is_flipped ? -both.normal : both.normal;
    side[t] = {static_cast<std::uint32_t>(t), is_flipped, glm::vec3(normal)};
    if (opens_room && is_outside(tracer, both.middle_m, normal)) is_removed[t] = 1;
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

std::vector<SurfaceSide> sides_from_everywhere(const Tracer& tracer, bool opens_room) {
  const PreparedScene& scene = tracer.scene();
  std::vector<std::uint8_t> is_shown(2 * scene.triangle.size(), 1);
  const auto side = [&](std::size_t k) {
    const Sides both = sides_of(scene, k / 2);
    const bool is_flipped = k % 2 == 1;
    return SurfaceSide{static_cast<std::uint32_t>(k / 2), is_flipped,
                       glm::vec3(is_flipped ? -both.normal : both.normal)};
  };
  tbb::parallel_for(std::size_t{0}, is_shown.size(), [&](std::size_t k) {
    const FlushDenormals flush;
    const Sides both = sides_of(scene, k / 2);
    if (opens_room && is_outside(tracer, both.middle_m, k % 2 == 1 ? -both.normal : both.normal))
      is_shown[k] = 0;
  });
  std::vector<SurfaceSide> shown;
  for (std::size_t k = 0; k < is_shown.size(); ++k)
    if (is_shown[k] != 0) shown.push_back(side(k));
  return shown;
}

}  // namespace calc
