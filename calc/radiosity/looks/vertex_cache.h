#pragma once
// Stores light vertices of a space: traced once, inspected, and used again instead of tracing.

#include "calc/radiosity/gather/settings.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/scene/prepared_scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// The vertices of one round and replicate: paths first..last.
struct VertexCacheBatch {
  std::uint64_t replicate = 0;
  std::uint32_t first = 0, last = 0;
  double absorbed_lm = 0.0, escaped_lm = 0.0;  // as in TracedPaths
  LightVertices vertices;
  std::vector<VertexOrigin> origins;     // [vertex]
  std::vector<std::uint32_t> luminaire;  // [vertex], in file order
};

struct VertexCache {
  std::string made_by;  // program and ray tracer, with versions
  std::string space_id;
  std::uint64_t scene = 0;  // scene_fingerprint()
  std::uint64_t seed = 1;
  int replicates = 0;
  std::uint64_t first_paths = 0, paths = 0;  // of one replicate: in the first round, in all
  glm::dvec3 origin_m{0.0};                  // of local coordinates
  std::size_t channels = 1;
  std::vector<VertexCacheBatch> batches;  // by replicate, then by round

  // Returns the result of trace_light_paths(), with rays = 0. Throws std::logic_error if the batch
  // is not here: settings must be those of the cache.
  TracedPaths take(const PathBatch& batch) const;
  std::uint64_t vertices() const;
};

struct TracedCache {
  std::optional<VertexCache> cache;
  std::string problem;  // why there is none
};
// Traces the paths of all rounds of settings.first_paths to max_paths in each of
// settings.replicates (here also 1 is allowed). The caller sets made_by and space_id.
TracedCache trace_vertex_cache(const PreparedScene& scene, const RadiositySettings& settings);

// Returns binary little-endian PLY, one vertex each with x, y, z (scene, m), nx, ny, nz, flux (lm;
// the sum over a replicate is all reflected flux), red, green, blue (by reflection), bounce (1 =
// first reflection), path, luminaire, light_group, replicate, and local_x, local_y, local_z, which
// restore the same bits however far the scene is from its origin. Comments hold the rest.
std::string render_vertex_ply(const VertexCache& cache);
std::uint64_t vertex_ply_bytes(const VertexCache& cache);  // without the header

// Reads exactly the files of render_vertex_ply() and refuses others: `problem` states why.
TracedCache parse_vertex_ply(std::string_view bytes);

}  // namespace calc
