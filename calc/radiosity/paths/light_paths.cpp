#include "calc/radiosity/paths/light_paths.h"

#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <vector>

namespace calc {
namespace {

constexpr std::size_t kUsualVertices = 4;  // of a path; more cost a move

struct Chunk {
  LightVertices vertices;
  std::vector<VertexOrigin> origins;
  double absorbed_lm = 0.0, escaped_lm = 0.0;
  std::uint64_t rays = 0;
  bool has_endless_path = false;
};

// A path on its way.
struct Path {
  std::uint32_t index;
  std::uint32_t channel;
  double weight_lm, survival, roulette;
  EmittedRay ray;
};

RandomKey sequence_key(std::uint64_t seed, std::uint64_t replicate) {
  return stage_key(seed, RandomStage::light_paths).with(replicate);
}

// All paths of a chunk advance together, one reflection at a time, so that their rays fill packets.
class PathWave {
 public:
  PathWave(const Tracer& tracer, const ScrambledSobol& sobol, bool keeps_origins, Chunk& chunk)
      : tracer_(tracer), sobol_(sobol), keeps_origins_(keeps_origins), chunk_(chunk) {
    paths_.reserve(kPathsPerChunk);
    chunk_.vertices.reserve(kUsualVertices * kPathsPerChunk);
  }

  void emit(const Emitter& emitter, std::uint32_t index, double paths) {
    const std::size_t luminaire =
        emitter.choose_luminaire(sobol_.sample(index, kLuminaireDimension));
    paths_.push_back(
        {index, tracer_.scene().luminaires[luminaire].channel,
         emitter.path_flux_lm(luminaire) / paths, 1.0,
         roulette_number(sobol_.sample(index, kRouletteDimension)),
         emitter.emit(luminaire, sobol_.sample_pair(index, kDirectionDimension),
                      sobol_.sample_pair(index, kOpeningDimension), tracer_.offset_m())});
  }

  // Sets is_cancelled, which other waves obey too, when the batch has become useless.
  void trace(const PathBatch& batch, std::atomic<std::uint64_t>& vertices,
             std::atomic<bool>& is_cancelled) {
    for (int reflection = 0; !paths_.empty(); ++reflection) {
      if (reflection >= batch.most_reflections) {
        chunk_.has_endless_path = true;
        is_cancelled = true;
      }
      if (is_past(batch.deadline_s)) is_cancelled = true;
      if (is_cancelled.load(std::memory_order_relaxed)) return;
      const std::size_t before = chunk_.vertices.size();
      std::size_t alive = 0;
      for (std::size_t first = 0; first < paths_.size(); first += RayPacket::kSize) {
        advance(first, std::min(paths_.size(), first + RayPacket::kSize), reflection, alive);
      }
      paths_.resize(alive);
      const std::size_t added = chunk_.vertices.size() - before;
      if ((vertices += added) > batch.most_vertices) is_cancelled = true;
    }
  }

 private:
  void advance(std::size_t first, std::size_t last, int reflection, std::size_t& alive) {
    packet_.count = 0;
    for (std::size_t k = first; k < last; ++k) {
      packet_.add(paths_[k].ray.origin_m, paths_[k].ray.direction);
    }
    chunk_.rays += last - first;
    const std::uint32_t hits =
        tracer_.closest_hits(packet_, 0.0f, std::numeric_limits<float>::infinity(), hit_);
    for (std::size_t k = 0; k < last - first; ++k) {
      if (((hits >> k) & 1u) == 0) {
        chunk_.escaped_lm += paths_[first + k].weight_lm;
      } else if (reflect(paths_[first + k], hit_[k], reflection)) {
        paths_[alive++] = paths_[first + k];
      }
    }
  }

  // False if the path ends here.
  bool reflect(Path& path, const SurfaceHit& hit, int reflection) {
    const double rho = tracer_.scene().reflectance[hit.triangle];
    chunk_.absorbed_lm += path.weight_lm * (1.0 - rho);
    if (rho <= 0.0) return false;
    const glm::dvec3 lifted = tracer_.lift(hit.position_m, hit.normal);
    chunk_.vertices.push_back({glm::vec3(lifted), static_cast<float>(path.weight_lm * rho),
                               glm::vec3(hit.normal), path.channel});
    if (keeps_origins_) {
      chunk_.origins.push_back({path.index, static_cast<std::uint32_t>(reflection)});
    }
    if (reflection < kFreeReflections) {
      path.weight_lm *= rho;
    } else {
      path.survival *= rho;
      if (path.survival <= path.roulette) return false;
    }
    const auto u = sobol_.sample_pair(path.index, kBounceDimension + 2 * reflection);
    path.ray = {lifted, cosine_direction(hit.normal, u[0], u[1])};
    return true;
  }

  const Tracer& tracer_;
  const ScrambledSobol& sobol_;
  bool keeps_origins_;
  Chunk& chunk_;
  std::vector<Path> paths_;
  RayPacket packet_;
  std::array<SurfaceHit, RayPacket::kSize> hit_;
};

}  // namespace

ScrambledSobol path_samples(const PathBatch& batch) {
  return ScrambledSobol(sequence_key(batch.seed, batch.replicate), kSobolDimensions);
}

TracedPaths trace_light_paths(const Tracer& tracer, const Emitter& emitter,
                              const PathBatch& batch) {
  const std::uint32_t paths = batch.last - batch.first;
  const ScrambledSobol sobol = path_samples(batch);
  std::atomic<std::uint64_t> vertices_so_far{0};
  std::atomic<bool> is_cancelled{false};
  std::vector<Chunk> chunks((paths + kPathsPerChunk - 1) / kPathsPerChunk);
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
    const FlushDenormals flush;
    const std::uint32_t begin = batch.first + static_cast<std::uint32_t>(c) * kPathsPerChunk;
    const std::uint32_t end = std::min(begin + kPathsPerChunk, batch.last);
    PathWave wave(tracer, sobol, batch.keeps_origins, chunks[c]);
    for (std::uint32_t i = begin; i < end; ++i) wave.emit(emitter, i, paths);
    wave.trace(batch, vertices_so_far, is_cancelled);
  });

  TracedPaths traced;
  std::size_t vertices = 0;
  for (const Chunk& chunk : chunks) vertices += chunk.vertices.size();
  traced.has_too_many_vertices = vertices_so_far > batch.most_vertices;
  if (!traced.has_too_many_vertices) traced.vertices.reserve(vertices);
  for (const Chunk& chunk : chunks) {
    if (!traced.has_too_many_vertices) {
      traced.vertices.insert(traced.vertices.end(), chunk.vertices.begin(), chunk.vertices.end());
      traced.origins.insert(traced.origins.end(), chunk.origins.begin(), chunk.origins.end());
    }
    traced.absorbed_lm += chunk.absorbed_lm;
    traced.escaped_lm += chunk.escaped_lm;
    traced.rays += chunk.rays;
    traced.has_endless_path = traced.has_endless_path || chunk.has_endless_path;
  }
  return traced;
}

std::size_t luminaire_of_path(const Emitter& emitter, std::uint64_t seed, std::uint64_t replicate,
                              std::uint32_t path) {
  const ScrambledSobol sobol(sequence_key(seed, replicate));
  return emitter.choose_luminaire(sobol.sample(path, kLuminaireDimension));
}

}  // namespace calc
