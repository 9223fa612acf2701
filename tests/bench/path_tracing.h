#pragma once
// Estimators of the benchmarks' own, to hold the calculation core against. They share only the
// tracer and the emission of luminaires with it.

#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/sampling/rays.h"
#include "tests/bench/room_model.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace bench {

// Indirect illuminance (lx) by cosine paths from every point, with the exact direct light of one
// luminaire, drawn by its unshadowed illuminance, at every hit: [replicate][point]. Unbiased
// without any bound or pool; slow, and noisy beside luminaires that wash a wall.
std::vector<std::vector<double>> trace_from_points(const BenchScene& scene, std::uint64_t paths,
                                                   int replicates, std::uint64_t seed);

enum class Roulette { per_bounce, one_number };

struct ReflectedLight {
  glm::dvec3 position_m, normal;
  double flux_lm;
};

struct RayQuery {
  glm::dvec3 origin_m, direction;
  double reach_m = std::numeric_limits<float>::infinity();
  int bounce = 0;
};

struct LightTrace {
  std::vector<ReflectedLight> vertices;
  std::vector<RayQuery> queries;  // if asked for
  double absorbed_lm = 0.0, escaped_lm = 0.0;
  std::uint64_t rays = 0;
};

// Light paths from all luminaires, on one thread. per_bounce: a path goes on with the probability
// of the surface's reflectance, an own random number each time, from the first reflection on; this
// is the random walk of the paper with a Sobol' sequence. one_number: the first reflection is free,
// then one number for the whole path.
LightTrace trace_light(const calc::Tracer& tracer, const calc::Emitter& emitter, Roulette roulette,
                       std::uint32_t paths, std::uint64_t seed, bool keeps_queries = false);

// Mean illuminance (lx) of the points from all vertices as if nothing stood between, geometry term
// at most most_per_m2.
std::vector<double> connect_unoccluded(
    const BenchScene& scene, const std::vector<ReflectedLight>& vertices,
    double most_per_m2 = std::numeric_limits<double>::infinity());

// The same with shadow rays: instant radiosity with all vertices, clamped.
std::vector<double> connect_clamped(const calc::Tracer& tracer, const BenchScene& scene,
                                    const std::vector<ReflectedLight>& vertices,
                                    double most_per_m2);

}  // namespace bench
