#include "calc/radiosity/light_paths.h"

#include "calc/radiosity/low_discrepancy.h"
#include "calc/radiosity/random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <vector>

namespace calc {
namespace {

constexpr std::uint32_t kPathsPerChunk =
    64;                              // fixed: sums are grouped the same way for any thread count
constexpr int kFreeReflections = 1;  // reflections before roulette begins

// Sobol' dimensions of a path.
constexpr int kLuminaireDimension = 0;
constexpr int kDirectionDimension = 1;  // and 2
constexpr int kRouletteDimension = 3;
constexpr int kOpeningDimension = 4;  // and 5
constexpr int kBounceDimension = 6;   // and 7, two more for every reflection

struct Vertex {
  glm::vec3 position_m, normal;
  double flux_lm;
  float bound_per_m2;
  std::uint32_t channel;
};

struct Chunk {
  std::vector<Vertex> vertices;
  double absorbed_lm = 0.0, escaped_lm = 0.0;
  std::uint64_t rays = 0;
  bool has_endless_path = false;
};

void trace_path(const Tracer& tracer, const Emitter& emitter, const GeometryBound& bound,
                const ScrambledSobol& sobol, std::uint32_t index, double path_flux_lm,
                Chunk& chunk) {
  const PreparedScene& scene = tracer.scene();
  const std::size_t luminaire = emitter.choose_luminaire(sobol.sample(index, kLuminaireDimension));
  EmittedRay ray = emitter.emit(luminaire, sobol.sample_pair(index, kDirectionDimension),
                                sobol.sample_pair(index, kOpeningDimension), tracer.offset_m());
  const double roulette = sobol.sample(index, kRouletteDimension);
  const std::uint32_t channel = scene.luminaires[luminaire].channel;
  double weight_lm = path_flux_lm;
  double survival = 1.0;
  for (int reflection = 0; reflection < kMostReflections; ++reflection) {
    SurfaceHit hit;
    ++chunk.rays;
    if (!tracer.closest_hit(ray.origin_m, ray.direction, std::numeric_limits<float>::infinity(),
                            hit)) {
      chunk.escaped_lm += weight_lm;
      return;
    }
    const double rho = scene.reflectance[hit.triangle];
    chunk.absorbed_lm += weight_lm * (1.0 - rho);
    if (rho <= 0.0) return;
    chunk.vertices.push_back({glm::vec3(hit.position_m), glm::vec3(hit.normal), weight_lm * rho,
                              static_cast<float>(bound.at(hit.position_m, hit.normal)), channel});
    if (reflection < kFreeReflections) {
      weight_lm *= rho;
    } else {
      survival *= rho;
      if (survival <= roulette) return;
    }
    const auto u = sobol.sample_pair(index, kBounceDimension + 2 * reflection);
    ray = {tracer.lift(hit.position_m, hit.normal), cosine_direction(hit.normal, u[0], u[1])};
  }
  chunk.has_endless_path = true;
}

// Chunks in order, grouped by channel.
LightVertices merge(const std::vector<Chunk>& chunks, std::size_t channels) {
  LightVertices merged;
  merged.channel_begin.assign(channels + 1, 0);
  for (const Chunk& chunk : chunks) {
    for (const Vertex& vertex : chunk.vertices) ++merged.channel_begin[vertex.channel + 1];
  }
  for (std::size_t c = 0; c < channels; ++c) merged.channel_begin[c + 1] += merged.channel_begin[c];
  const std::size_t count = merged.channel_begin.back();
  merged.position_m.resize(count);
  merged.normal.resize(count);
  merged.flux_lm.resize(count);
  merged.bound_per_m2.resize(count);
  std::vector<std::uint32_t> next(merged.channel_begin.begin(), merged.channel_begin.end() - 1);
  for (const Chunk& chunk : chunks) {
    for (const Vertex& vertex : chunk.vertices) {
      const std::size_t i = next[vertex.channel]++;
      merged.position_m[i] = vertex.position_m;
      merged.normal[i] = vertex.normal;
      merged.flux_lm[i] = vertex.flux_lm;
      merged.bound_per_m2[i] = vertex.bound_per_m2;
    }
  }
  return merged;
}

}  // namespace

TracedPaths trace_light_paths(const Tracer& tracer, const Emitter& emitter,
                              const GeometryBound& bound, const PathBatch& batch) {
  const std::uint32_t paths = batch.last - batch.first;
  const double path_flux_lm = emitter.flux_lm() / paths;
  const ScrambledSobol sobol(stage_key(batch.seed, RandomStage::light_paths).with(batch.replicate));
  std::atomic<bool> is_endless{false};  // one endless path refuses the scene: the rest need not run
  std::vector<Chunk> chunks((paths + kPathsPerChunk - 1) / kPathsPerChunk);
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
    const FlushDenormals flush;
    const std::uint32_t begin = batch.first + static_cast<std::uint32_t>(c) * kPathsPerChunk;
    const std::uint32_t end = std::min(begin + kPathsPerChunk, batch.last);
    for (std::uint32_t i = begin; i < end && !is_endless; ++i) {
      trace_path(tracer, emitter, bound, sobol, i, path_flux_lm, chunks[c]);
      if (chunks[c].has_endless_path) is_endless = true;
    }
  });

  TracedPaths traced;
  for (const Chunk& chunk : chunks) {
    traced.absorbed_lm += chunk.absorbed_lm;
    traced.escaped_lm += chunk.escaped_lm;
    traced.rays += chunk.rays;
    traced.has_endless_path = traced.has_endless_path || chunk.has_endless_path;
  }
  traced.vertices = merge(chunks, tracer.scene().channels.size());
  return traced;
}

}  // namespace calc
