#include "calc/radiosity/looks/vertex_cache.h"

#include "calc/proofs/beam.h"
#include "calc/proofs/predicates.h"
#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/looks/scene_fingerprint.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace calc {
namespace {

// "" or why the paths are useless.
std::string trace_batch(const Tracer& tracer, const Emitter& emitter, std::uint64_t seed,
                        VertexCacheBatch& batch) {
  PathBatch paths{seed, batch.replicate, batch.first, batch.last};
  paths.keeps_origins = true;
  TracedPaths traced = trace_light_paths(tracer, emitter, paths);
  if (traced.has_endless_path) {
    return fmt::format("a light path did not end after {} reflections", kMostReflections);
  }
  if (traced.has_too_many_vertices) {
    return fmt::format(
        "one sampling round takes more than {} light vertices; fewer paths may be enough",
        kMostVertices);
  }
  batch.absorbed_lm = traced.absorbed_lm;
  batch.escaped_lm = traced.escaped_lm;
  batch.vertices = std::move(traced.vertices);
  batch.origins = std::move(traced.origins);
  std::vector<std::uint32_t> of_path(batch.last - batch.first);
  for (std::uint32_t p = batch.first; p < batch.last; ++p) {
    of_path[p - batch.first] =
        static_cast<std::uint32_t>(luminaire_of_path(emitter, seed, batch.replicate, p));
  }
  for (const VertexOrigin& origin : batch.origins) {
    batch.luminaire.push_back(of_path[origin.path - batch.first]);
  }
  return "";
}

std::string trace_all(const PreparedScene& scene, std::span<const std::uint8_t> is_unlit,
                      VertexCache& cache) {
  const Emitter emitter(scene, is_unlit);
  if (!(emitter.traced_flux_lm() > 0.0) || no_reflection(scene)) {
    return "no light reaches a surface that reflects: there are no light vertices";
  }
  const Tracer tracer(scene);
  for (int r = 0; r < cache.replicates; ++r) {
    std::uint64_t first = 0;
    for (std::uint64_t last = cache.first_paths; last <= cache.paths; last *= 2) {
      VertexCacheBatch& batch = cache.batches.emplace_back();
      batch.replicate = static_cast<std::uint64_t>(r);
      batch.first = static_cast<std::uint32_t>(first);
      batch.last = static_cast<std::uint32_t>(last);
      std::string problem = trace_batch(tracer, emitter, cache.seed, batch);
      if (!problem.empty()) return problem;
      first = last;
    }
  }
  return "";
}

}  // namespace

TracedPaths VertexCache::take(const PathBatch& batch) const {
  const auto found =
      std::find_if(batches.begin(), batches.end(), [&](const VertexCacheBatch& kept) {
        return kept.replicate == batch.replicate && kept.first == batch.first &&
               kept.last == batch.last;
      });
  if (found == batches.end() || batch.seed != seed) {
    throw std::logic_error(fmt::format("the light-vertex cache has no paths {} to {} of {}",
                                       batch.first, batch.last, batch.replicate));
  }
  TracedPaths traced;
  traced.vertices = found->vertices;
  traced.absorbed_lm = found->absorbed_lm;
  traced.escaped_lm = found->escaped_lm;
  return traced;
}

std::uint64_t VertexCache::vertices() const {
  std::uint64_t sum = 0;
  for (const VertexCacheBatch& batch : batches) sum += batch.vertices.size();
  return sum;
}

TracedCache trace_vertex_cache(const PreparedScene& scene, const RadiositySettings& settings) {
  VertexCache cache;
  cache.seed = settings.seed;
  cache.replicates = settings.replicates;
  cache.first_paths = settings.first_paths;
  cache.paths = settings.max_paths;
  cache.origin_m = scene.origin_m;
  cache.channels = scene.channels.size();
  const std::vector<std::uint8_t> is_unlit =
      unlit_luminaires(scene, beams_of(scene), settings.skips);
  cache.scene = scene_fingerprint(scene, is_unlit);
  std::string problem;
  on_threads(settings.jobs, [&] { problem = trace_all(scene, is_unlit, cache); });
  if (!problem.empty()) return {std::nullopt, std::move(problem)};
  return {std::move(cache), ""};
}

}  // namespace calc
