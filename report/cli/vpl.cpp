#include "report/cli/vpl.h"

#include "calc/radiosity/scene_fingerprint.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/project_xml.h"
#include "report/cli/chosen_space.h"
#include "report/cli/outputs.h"
#include "report/cli/recording_reader.h"
#include "report/cli/version.h"
#include "report/number_format.h"
#include "report/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cli {
namespace {

// What readers of files take, with room for the header.
constexpr std::uint64_t kLargestFileBytes = std::uint64_t{510} << 20;
constexpr int kFewestReplicates = 4;

std::string maker() {
  return fmt::format("luxgate {} ({})", program_version(), calc::tracer_version());
}

double reflected_lm(const calc::VertexCache& cache) {
  double sum = 0.0;
  for (const calc::VertexCacheBatch& batch : cache.batches) {
    const double share = static_cast<double>(batch.last - batch.first) /
                         static_cast<double>(cache.paths * static_cast<unsigned>(cache.replicates));
    for (const calc::LightVertex& vertex : batch.vertices) {
      sum += share * static_cast<double>(vertex.flux_lm);
    }
  }
  return sum;
}

std::string summary(const std::string& file, std::size_t bytes, const calc::VertexCache& cache) {
  return fmt::format(
      "Wrote {}: {} light vertices of {} paths ({} replicates of {}), {:.3g} MB\n"
      "space '{}', seed {}: {} lm of reflected flux\n",
      file, report::format_count(cache.vertices()),
      report::format_count(cache.paths * static_cast<unsigned>(cache.replicates)), cache.replicates,
      report::format_count(cache.paths), 1e-6 * static_cast<double>(bytes), cache.space_id,
      cache.seed, report::format_lumens(reflected_lm(cache)));
}

// "" after an error.
std::string write_vertices(const VplOptions& options, const RecordingReader& files,
                           calc::Diagnostics& diagnostics) {
  const auto output_problem = [&](const std::string& problem) {
    diagnostics.report(calc::DiagnosticId::output_not_possible, {}, problem);
    return std::string();
  };
  const std::optional<calc::Project> project =
      calc::load_project(files, options.project, diagnostics);
  if (!project || diagnostics.has_errors()) return "";
  const calc::Space* space = find_chosen_space(*project, options.space, diagnostics);
  if (space == nullptr) return "";
  for (const std::string& input : files.paths()) {
    if (path_identity(input) != path_identity(options.output)) continue;
    return output_problem(
        fmt::format("'{}' was read as an input and is not overwritten", options.output));
  }
  const std::string unwritable = writability(options.output);
  if (!unwritable.empty()) return output_problem(unwritable);
  calc::RadiositySettings settings = options.radiosity;
  settings.first_paths = std::min(settings.first_paths, settings.max_paths);
  calc::TracedCache traced =
      calc::trace_vertex_cache(calc::prepare_scene(*project, *space), settings);
  if (!traced.cache) {
    diagnostics.report(calc::DiagnosticId::no_vertex_cache, space->where, space->id,
                       traced.problem);
    return "";
  }
  traced.cache->made_by = maker();
  traced.cache->space_id = space->id;
  if (calc::vertex_ply_bytes(*traced.cache) > kLargestFileBytes) {
    return output_problem(fmt::format(
        "'{}' would have {:.0f} MB; at most {} MB can be read again: take fewer paths or "
        "replicates",
        options.output, 1e-6 * static_cast<double>(calc::vertex_ply_bytes(*traced.cache)),
        kLargestFileBytes / 1'000'000));
  }
  const std::string bytes = calc::render_vertex_ply(*traced.cache);
  const std::string problem = report::write_file_atomically(options.output, bytes);
  if (!problem.empty()) {
    return output_problem(fmt::format("cannot write '{}': {}", options.output, problem));
  }
  return summary(options.output, bytes.size(), *traced.cache);
}

}  // namespace

CommandOutcome run_vpl(const VplOptions& options, const calc::FileReader& disk) {
  const RecordingReader files(disk);
  calc::Diagnostics diagnostics;
  CommandOutcome outcome;
  outcome.text = write_vertices(options, files, diagnostics);
  if (outcome.text.empty()) outcome.code = kNotJudged;
  outcome.diagnostics = diagnostics.all();
  return outcome;
}

std::optional<calc::VertexCache> read_vertex_cache(const std::string& path,
                                                   const calc::FileReader& files,
                                                   calc::Diagnostics& diagnostics) {
  const calc::FileContent content = files.read(path);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
    return std::nullopt;
  }
  calc::TracedCache parsed = calc::parse_vertex_ply(content.bytes);
  if (parsed.cache && parsed.cache->made_by != maker()) {
    parsed.problem = fmt::format("it was made by {}, this is {}", parsed.cache->made_by, maker());
  } else if (parsed.cache && parsed.cache->replicates < kFewestReplicates) {
    parsed.problem = fmt::format("it has {} replicates; intervals need {} or more",
                                 parsed.cache->replicates, kFewestReplicates);
  }
  if (parsed.problem.empty()) return std::move(parsed.cache);
  diagnostics.report(calc::DiagnosticId::vertex_cache_unreadable, {path, 0, 0}, parsed.problem);
  return std::nullopt;
}

void use_settings_of(const calc::VertexCache& cache, calc::RadiositySettings& settings) {
  settings.seed = cache.seed;
  settings.replicates = cache.replicates;
  settings.first_paths = cache.first_paths;
  settings.max_paths = cache.paths;
}

bool has_space_of(const calc::VertexCache& cache, const calc::Project& project,
                  const Options& options, calc::Diagnostics& diagnostics) {
  for (const calc::Space& space : project.spaces) {
    if (space.id == cache.space_id) return true;
  }
  diagnostics.report(calc::DiagnosticId::vertex_cache_unfit, {options.vpl_file, 0, 0},
                     fmt::format("they are of the space '{}', which '{}' does not have",
                                 cache.space_id, project.path));
  return false;
}

bool fits(const calc::VertexCache& cache, const calc::PreparedScene& scene, const Options& options,
          calc::Diagnostics& diagnostics) {
  const std::uint64_t print =
      calc::scene_fingerprint(scene, calc::unlit_luminaires(scene, options.radiosity));
  if (print == cache.scene && cache.channels == scene.channels.size()) return true;
  diagnostics.report(
      calc::DiagnosticId::vertex_cache_unfit, {options.vpl_file, 0, 0},
      fmt::format("they are of another scene ({:016x}, now {:016x}): surfaces, reflectances, "
                  "luminaires, photometry or --no-skip have changed; make them anew with "
                  "'luxgate vpl'",
                  cache.scene, print));
  return false;
}

}  // namespace cli
