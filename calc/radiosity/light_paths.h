#pragma once
// Light paths from luminaires through the room: the pool of light vertices and the flux balance.

#include "calc/radiosity/emission.h"
#include "calc/radiosity/light_vertex.h"
#include "calc/radiosity/rays.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// Paths first..last (indices of one replicate's low-discrepancy sequence).
struct PathBatch {
  std::uint64_t seed = 0;
  std::uint64_t replicate = 0;
  std::uint32_t first = 0, last = 0;
  double deadline_s = 0.0;     // see is_past(); the rest is then left undone, to be thrown away
  bool keeps_origins = false;  // fills TracedPaths::origins
};

// Where a light vertex comes from.
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
  // A path did not end after kMostReflections: there is no steady state. vertices are then useless.
  bool has_endless_path = false;
  bool has_too_many_vertices = false;  // more than kMostVertices; they are then useless
};

// Light vertices of one batch: about 1.2 GB with all that is built on them.
inline constexpr std::uint64_t kMostVertices = std::uint64_t{1} << 23;

inline constexpr int kMostReflections = 100000;

// Paths end by one random number each: after the first reflection a path lives until the product of
// reflectances falls to that number. Exact in the mean, and path lengths come out stratified.
// [method 02, section 3] Parallel inside; the result does not depend on the number of threads.
TracedPaths trace_light_paths(const Tracer& tracer, const Emitter& emitter, const PathBatch& batch);

// The luminaire that a path of a replicate starts from.
std::size_t luminaire_of_path(const Emitter& emitter, std::uint64_t seed, std::uint64_t replicate,
                              std::uint32_t path);

}  // namespace calc
