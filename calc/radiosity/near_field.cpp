#include "calc/radiosity/near_field.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/low_discrepancy.h"
#include "calc/radiosity/shadow_batch.h"
#include "calc/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace calc {
namespace {

// Share of the local vertex density at which short rays take over: a vertex then adds at most kappa
// / pi of the illuminance it stands for.  [measured: 0.01 keeps points beside luminaire hot spots
// within 2 %]
constexpr double kKappa = 0.01;
constexpr double kMeanFreePathsPerReach = 1.0 / 3.0;
constexpr double kHighestMeanReflectance = 0.999;  // only shapes the bound; never a result
// Vertices that continue a short ray's hit. The mean over many rays smooths their noise.
constexpr std::uint32_t kFarDraws = 8;

struct SurfaceSummary {
  double area_m2 = 0.0;
  double mean_reflectance = 0.0;
  double mean_free_path_m = 1.0;
};

SurfaceSummary summarise(const PreparedScene& scene) {
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
  // 4 V / S of the bounding box: the mean chord of a convex body [Cauchy]. A flat scene has no
  // volume and takes its extent.
  const glm::dvec3 size = glm::max(high - low, glm::dvec3(0.0));
  const double surface = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
  const double chord = surface > 0.0 ? 4.0 * size.x * size.y * size.z / surface : 0.0;
  summary.mean_free_path_m = chord > 1e-6 * scene.extent_m ? chord : scene.extent_m;
  return summary;
}

double dot_self(const glm::dvec3& v) { return glm::dot(v, v); }

// Illuminance at y from `kFarDraws` vertices, evenly spaced in the batch from a random start.
std::uint64_t add_far_draws(const Tracer& tracer, const LightVertices& vertices,
                            const SurfaceHit& at, double u, double weight, double* sums,
                            std::size_t stride) {
  const auto count = static_cast<std::uint32_t>(vertices.size());
  if (count == 0) return 0;
  const std::uint32_t draws = std::min(kFarDraws, count);
  const double spacing = static_cast<double>(count) / draws;
  ShadowBatch batch(tracer, tracer.lift(at.position_m, at.normal), sums, stride);
  for (std::uint32_t k = 0; k < draws; ++k) {
    const auto j = std::min(static_cast<std::uint32_t>((k + u) * spacing), count - 1);
    const glm::dvec3 position(vertices.position_m[j]);
    const glm::dvec3 normal(vertices.normal[j]);
    const double g = geometry_term(at.position_m, at.normal, position, normal);
    if (g <= 0.0) continue;
    const double bounded = std::min(g, static_cast<double>(vertices.bound_per_m2[j]));
    const auto channel =
        std::upper_bound(vertices.channel_begin.begin() + 1, vertices.channel_begin.end(), j) -
        vertices.channel_begin.begin() - 1;
    batch.add(glm::vec3(tracer.lift(position, normal)),
              weight * spacing * vertices.flux_lm[j] / kPi * bounded,
              static_cast<std::uint32_t>(channel));
  }
  batch.flush();
  return batch.rays();
}

}  // namespace

GeometryBound::GeometryBound(const Tracer& tracer, const Emitter& emitter, std::uint64_t paths)
    : tracer_(tracer) {
  const SurfaceSummary summary = summarise(tracer.scene());
  reach_m_ = kMeanFreePathsPerReach * summary.mean_free_path_m;
  smallest_ = 1.0 / (reach_m_ * reach_m_);
  const double paths_number = static_cast<double>(paths);
  vertices_per_lumen_ = kKappa * paths_number / emitter.flux_lm();
  const double rho = std::min(summary.mean_reflectance, kHighestMeanReflectance);
  // Sumpner: E_amb = rho Phi / (A (1 - rho)), so that Phi cancels.
  if (summary.area_m2 > 0.0) {
    ambient_per_m2_ = kKappa * paths_number * rho / (summary.area_m2 * (1.0 - rho));
  }
}

double GeometryBound::at(const glm::dvec3& position_m, const glm::dvec3& normal) const {
  const auto& luminaires = tracer_.scene().luminaires;
  // A luminaire that could not lift the bound by its share of the smallest one is not worth a look.
  const double smallest_lx =
      smallest_ / (vertices_per_lumen_ * static_cast<double>(luminaires.size()));
  double direct_lx = 0.0;
  for (const PlacedLuminaire& luminaire : luminaires) {
    const double most_lx = luminaire.web->max_intensity_cd() * luminaire.flux_scale /
                           dot_self(luminaire.position_m - position_m);
    if (most_lx < smallest_lx) continue;
    const double lx = point_illuminance_lx(luminaire, luminaire.position_m, position_m, normal);
    if (lx < smallest_lx) continue;
    const glm::dvec3 source =
        lifted_source_m(luminaire, luminaire.position_m, position_m, tracer_.offset_m());
    if (!tracer_.is_blocked(tracer_.lift(position_m, normal), source)) direct_lx += lx;
  }
  return std::max(smallest_, vertices_per_lumen_ * direct_lx + ambient_per_m2_);
}

glm::dvec3 cosine_direction(const glm::dvec3& normal, double u0, double u1) {
  // Frame without a branch at the poles [Duff et al. 2017].
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const glm::dvec3 s(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const glm::dvec3 t(b, sign + normal.y * normal.y * a, -normal.y);
  const double radius = std::sqrt(u0);
  const double angle = 2.0 * kPi * u1;
  return glm::normalize(radius * std::cos(angle) * s + radius * std::sin(angle) * t +
                        std::sqrt(1.0 - u0) * normal);
}

std::uint64_t add_near_field(const Tracer& tracer, const GeometryBound& bound,
                             const LightVertices& vertices, const NearFieldRequest& request,
                             double* sums, std::size_t stride) {
  const ScrambledSobol sobol(request.key);
  const double ray_weight = 1.0 / (request.last_ray - request.first_ray);
  std::uint64_t rays = 0;
  for (std::uint32_t ray = request.first_ray; ray < request.last_ray; ++ray) {
    const RandomKey ray_key = request.key.with(ray);
    glm::dvec3 position = request.position_m;
    glm::dvec3 normal = request.normal;
    std::array<double, 2> u = sobol.sample_pair(ray, 0);
    double weight = ray_weight;
    for (std::uint64_t depth = 0;; ++depth) {
      SurfaceHit hit;
      ++rays;
      if (!tracer.closest_hit(tracer.lift(position, normal), cosine_direction(normal, u[0], u[1]),
                              bound.reach_m(), hit)) {
        break;
      }
      const double rho = tracer.scene().reflectance[hit.triangle];
      const double g = geometry_term(position, normal, hit.position_m, hit.normal);
      if (rho <= 0.0 || g <= bound.smallest()) break;
      const double missing = 1.0 - bound.at(hit.position_m, hit.normal) / g;
      if (missing <= 0.0) break;

      const RandomKey key = ray_key.with(depth);
      const double factor = missing * rho;
      if (depth == 0) {
        weight *= factor;
      } else if (key.with(0).uniform() >= factor) {
        break;  // roulette with survival probability `factor`: the weight stays
      }
      rays +=
          add_direct_sample(tracer, hit.position_m, hit.normal, key.with(1), weight, sums, stride);
      rays += add_far_draws(tracer, vertices, hit, key.with(2).uniform(), weight, sums, stride);
      u = {key.with(3).uniform(), key.with(4).uniform()};
      position = hit.position_m;
      normal = hit.normal;
    }
  }
  return rays;
}

}  // namespace calc
