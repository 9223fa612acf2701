#include "tests/bench/path_tracing.h"

#include "calc/base/units.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kDimensions = 4;  // of a path from a point, per hit: direction, luminaire, roulette
constexpr int kSafeHits = 3;    // before roulette begins

// Direct illuminance at a hit from one luminaire drawn by its unshadowed part; unbiased.
double direct_sample_lx(const calc::Tracer& tracer, const glm::dvec3& y, const glm::dvec3& normal,
                        double u, std::vector<double>& cumulative) {
  cumulative.clear();
  double sum = 0.0;
  const auto& luminaires = tracer.scene().luminaires;
  for (const calc::PlacedLuminaire& luminaire : luminaires) {
    sum += calc::point_illuminance_lx(luminaire, luminaire.position_m, {y, normal});
    cumulative.push_back(sum);
  }
  if (!(sum > 0.0)) return 0.0;
  const auto chosen = std::upper_bound(cumulative.begin(), cumulative.end() - 1, u * sum);
  const auto& luminaire = luminaires[static_cast<std::size_t>(chosen - cumulative.begin())];
  const glm::dvec3 source =
      calc::lifted_source_m(luminaire, luminaire.position_m, y, tracer.offset_m());
  return tracer.is_blocked(tracer.lift(y, normal), source) ? 0.0 : sum;
}

double path_lx(const calc::Tracer& tracer, glm::dvec3 position, glm::dvec3 normal,
               const calc::ScrambledSobol& sobol, std::uint32_t index,
               std::vector<double>& scratch) {
  double lx = 0.0, weight = 1.0;
  for (int hit_number = 0;; ++hit_number) {
    const int dimension = kDimensions * hit_number;
    const auto u = sobol.sample_pair(index, dimension);
    calc::SurfaceHit hit;
    if (!tracer.closest_hit(tracer.lift(position, normal),
                            calc::cosine_direction(normal, u[0], u[1]), kInfinity, hit)) {
      return lx;
    }
    const double rho = tracer.scene().reflectance[hit.triangle];
    if (hit_number < kSafeHits) {
      weight *= rho;
    } else if (sobol.sample(index, dimension + 3) >= rho) {
      return lx;
    }
    if (!(weight > 0.0)) return lx;
    lx += weight * direct_sample_lx(tracer, hit.position_m, hit.normal,
                                    sobol.sample(index, dimension + 2), scratch);
    position = hit.position_m;
    normal = hit.normal;
  }
}

double geometry(const glm::dvec3& x, const glm::dvec3& nx, const ReflectedLight& vertex,
                double most_per_m2) {
  return std::min(calc::geometry_term(x, nx, vertex.position_m, vertex.normal), most_per_m2);
}

template <typename Visible>
std::vector<double> connect(const BenchScene& scene, const std::vector<ReflectedLight>& vertices,
                            double most_per_m2, const Visible& is_visible) {
  std::vector<double> lx(scene.points(), 0.0);
  tbb::parallel_for(std::size_t{0}, scene.points(), [&](std::size_t i) {
    const calc::FlushDenormals flush;
    const glm::dvec3 x = scene.grid.position_m[i] - scene.scene.origin_m;
    const glm::dvec3& normal = scene.grid.normal[i];
    for (const ReflectedLight& vertex : vertices) {
      const double g = geometry(x, normal, vertex, most_per_m2);
      if (g > 0.0 && is_visible(x, normal, vertex)) lx[i] += vertex.flux_lm / calc::kPi * g;
    }
  });
  return lx;
}

}  // namespace

std::vector<std::vector<double>> trace_from_points(const BenchScene& scene, std::uint64_t paths,
                                                   int replicates, std::uint64_t seed) {
  const calc::Tracer tracer(scene.scene);
  std::vector<std::vector<double>> lx(static_cast<std::size_t>(replicates),
                                      std::vector<double>(scene.points(), 0.0));
  tbb::parallel_for(std::size_t{0}, scene.points(), [&](std::size_t i) {
    const calc::FlushDenormals flush;
    std::vector<double> scratch;
    const glm::dvec3 position = scene.grid.position_m[i] - scene.scene.origin_m;
    for (std::size_t r = 0; r < lx.size(); ++r) {
      const calc::ScrambledSobol sobol(calc::RandomKey(seed).with("from points").with(r).with(i));
      double sum = 0.0;
      for (std::uint64_t p = 0; p < paths; ++p) {
        sum += path_lx(tracer, position, scene.grid.normal[i], sobol, static_cast<std::uint32_t>(p),
                       scratch);
      }
      lx[r][i] = sum / static_cast<double>(paths);
    }
  });
  return lx;
}

LightTrace trace_light(const calc::Tracer& tracer, const calc::Emitter& emitter, Roulette roulette,
                       std::uint32_t paths, std::uint64_t seed, bool keeps_queries) {
  const calc::FlushDenormals flush;
  const calc::ScrambledSobol sobol(calc::RandomKey(seed).with("light of the benchmark"));
  LightTrace trace;
  for (std::uint32_t path = 0; path < paths; ++path) {
    calc::EmittedRay ray = emitter.emit(emitter.choose_luminaire(sobol.sample(path, 0)),
                                        sobol.sample_pair(path, 1), {0.5, 0.5}, tracer.offset_m());
    const double one_number = sobol.sample(path, 3);
    double flux_lm = emitter.flux_lm() / paths, survival = 1.0;
    for (int bounce = 0;; ++bounce) {
      ++trace.rays;
      if (keeps_queries) trace.queries.push_back({ray.origin_m, ray.direction, kInfinity, bounce});
      calc::SurfaceHit hit;
      if (!tracer.closest_hit(ray.origin_m, ray.direction, kInfinity, hit)) {
        trace.escaped_lm += flux_lm;
        break;
      }
      const double rho = tracer.scene().reflectance[hit.triangle];
      trace.absorbed_lm += flux_lm * (1.0 - rho);
      if (!(rho > 0.0)) break;
      trace.vertices.push_back(
          {tracer.lift(hit.position_m, hit.normal), hit.normal, flux_lm * rho});
      const int dimension = 4 + 3 * bounce;
      if (roulette == Roulette::per_bounce) {
        if (sobol.sample(path, dimension + 2) >= rho) break;
      } else if (bounce == 0) {
        flux_lm *= rho;
      } else {
        survival *= rho;
        if (survival <= one_number) break;
      }
      const auto u = sobol.sample_pair(path, dimension);
      ray = {tracer.lift(hit.position_m, hit.normal),
             calc::cosine_direction(hit.normal, u[0], u[1])};
    }
  }
  return trace;
}

std::vector<double> connect_unoccluded(const BenchScene& scene,
                                       const std::vector<ReflectedLight>& vertices,
                                       double most_per_m2) {
  return connect(scene, vertices, most_per_m2,
                 [](const auto&, const auto&, const auto&) { return true; });
}

std::vector<double> connect_clamped(const calc::Tracer& tracer, const BenchScene& scene,
                                    const std::vector<ReflectedLight>& vertices,
                                    double most_per_m2) {
  return connect(scene, vertices, most_per_m2,
                 [&](const glm::dvec3& x, const glm::dvec3& normal, const ReflectedLight& vertex) {
                   return !tracer.is_blocked(tracer.lift(x, normal), vertex.position_m);
                 });
}

}  // namespace bench
