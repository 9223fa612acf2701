#include "report/check/vertex_source.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/numbers_version.h"
#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/looks/scene_fingerprint.h"
#include "report/document/program_version.h"

#include <fmt/format.h>

#include <utility>

namespace check {

std::string vertex_maker() {
  return fmt::format("luxgate {} (numbers version {})", report::program_version(),
                     calc::kNumbersVersion);
}

std::optional<VertexSource> read_vertex_source(const std::string& path,
                                               const calc::FileReader& files,
                                               calc::Diagnostics& diagnostics) {
  const calc::FileContent content = files.read(path);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
    return std::nullopt;
  }
  calc::TracedCache parsed = calc::parse_vertex_ply(content.bytes);
  if (parsed.cache && parsed.cache->made_by != vertex_maker()) {
    parsed.problem = fmt::format("it was made by {}, but this program is {}", parsed.cache->made_by,
                                 vertex_maker());
  } else if (parsed.cache && parsed.cache->replicates < calc::kFewestReplicates) {
    parsed.problem = fmt::format("it has {} replicates; intervals need {} or more",
                                 parsed.cache->replicates, calc::kFewestReplicates);
  }
  if (parsed.problem.empty()) return VertexSource{path, std::move(*parsed.cache)};
  diagnostics.report(calc::DiagnosticId::vertex_cache_unreadable, {path, 0, 0}, parsed.problem);
  return std::nullopt;
}

void use_settings_of(const calc::VertexCache& cache, calc::RadiositySettings& settings) {
  settings.seed = cache.seed;
  settings.replicates = cache.replicates;
  settings.first_paths = cache.first_paths;
  settings.max_paths = cache.paths;
}

bool has_space_of(const VertexSource& source, const calc::Project& project,
                  calc::Diagnostics& diagnostics) {
  for (const calc::Space& space : project.spaces) {
    if (space.id == source.cache.space_id) return true;
  }
  diagnostics.report(calc::DiagnosticId::vertex_cache_unfit, {source.file, 0, 0},
                     fmt::format("they are of the space '{}', which '{}' does not have",
                                 source.cache.space_id, project.path));
  return false;
}

bool fits(const VertexSource& source, const calc::PreparedScene& scene, const calc::SkipSet& skips,
          calc::Diagnostics& diagnostics) {
  const calc::VertexCache& cache = source.cache;
  const std::uint64_t print =
      calc::scene_fingerprint(scene, calc::unlit_luminaires(scene, calc::beams_of(scene), skips));
  if (print == cache.scene && cache.channels == scene.channels.size()) return true;
  diagnostics.report(
      calc::DiagnosticId::vertex_cache_unfit, {source.file, 0, 0},
      fmt::format("they are of another scene ({:016x}, now {:016x}): surfaces, reflectances, "
                  "luminaires, photometry or --no-skip have changed. Make them again with "
                  "'luxgate vpl'",
                  cache.scene, print));
  return false;
}

}  // namespace check
