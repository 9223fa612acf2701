#pragma once
// Traces light paths through the room: the pool of light vertices and the flux balance.

#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/rays.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// Most light vertices of one batch: about 1.2 GB with all data built on them.
inline constexpr std::uint64_t kMostVertices = std::uint64_t{1} << 23;

inline constexpr int kMostReflections = 300000;

// Paths that advance together: sums and the order of vertices are by such chunks, for any number of
// threads. Vertices of a chunk are ordered by reflections, then by paths.
inline constexpr std::uint32_t kPathsPerChunk = 256;

// Reflections before roulette begins.
inline constexpr int kFreeReflections = 1;

// Sobol' dimensions of a path.
enum PathDimension : int {
  kLuminaireDimension = 0,
  kDirectionDimension = 1,  // and 2
  kRouletteDimension = 3,
  kOpeningDimension = 4,  // and 5
  kBounceDimension = 6    // and 7, two more for every reflection
};

// The paths first..last (indices of one replicate's low-discrepancy sequence).
struct PathBatch {
  std::uint64_t seed = 0;
  std::uint64_t replicate = 0;
  std::uint32_t first = 0, last = 0;
  double deadline_s = 0.0;  // see is_past(); the rest is then left undone, to be thrown away
  std::uint64_t most_vertices = kMostVertices;
  int most_reflections = kMostReflections;  // of one path
  bool keeps_origins = false;               // fills TracedPaths::origins
};

// The origin of a light vertex.
struct VertexOrigin {
  std::uint32_t path;        // index in the replicate's sequence
  std::uint32_t reflection;  // 0 = the path's first
};

struct TracedPaths {
  LightVertices vertices;  // in no useful order; flux such that their sum over the batch estimates
                           // all reflected flux
  std::vector<VertexOrigin> origins;  // [vertex], if asked for
  double absorbed_lm = 0.0;           // mean over the batch's paths, like all of these
  double escaped_lm = 0.0;
  std::uint64_t rays = 0;
  // A path did not end after most_reflections: there is no steady state. vertices are then useless.
  bool has_endless_path = false;
  bool has_too_many_vertices = false;  // more than most_vertices; they are then useless
};

// Returns the sequence of a batch's random numbers: path i uses its point i.
ScrambledSobol path_samples(const PathBatch& batch);

// Traces the paths. Each ends by one random number: after the first reflection a path lives until
// the product of reflectances falls to that number. Exact in the mean, and path lengths are
// stratified. [METHOD, 3.3] Parallel inside; the result does not depend on the number of threads.
TracedPaths trace_light_paths(const Tracer& tracer, const Emitter& emitter, const PathBatch& batch);

// Returns the luminaire that a path of a replicate starts from.
std::size_t luminaire_of_path(const Emitter& emitter, std::uint64_t seed, std::uint64_t replicate,
                              std::uint32_t path);

}  // namespace calc
