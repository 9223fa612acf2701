#include "report/tools/export/export.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "report/check/load_judged_project.h"
#include "report/formats/write.h"
#include "report/result_file/read_json.h"
#include "report/shell/options/chosen_space.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/output/outputs.h"
#include "report/text/plain_text.h"
#include "report/tools/export/gltf_files.h"
#include "report/tools/export/ifc_results.h"
#include "report/tools/export/radiance_lights.h"
#include "report/tools/export/radiance_scene.h"
#include "report/tools/export/radiance_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

namespace cli {
namespace {

namespace fs = std::filesystem;
using calc::DiagnosticId;

// Grids of all planes of illuminance; what is left out is said.
std::vector<calc::SensorGrid> grids_of(const calc::Space& space, std::vector<std::string>& ids,
                                       std::vector<std::string>& changed,
                                       calc::Diagnostics& diagnostics) {
  std::vector<calc::SensorGrid> grids;
  for (const calc::CalcPlane& plane : space.planes) {
    if (!radiance::is_sum_of_sensors(plane.derived)) {
      changed.push_back(fmt::format(
          "plane '{}' has the quantity '{}', which is not a sum of illuminances: it is omitted",
          plane.id, calc::quantity_name(plane.kernel, plane.derived)));
      continue;
    }
    std::optional<calc::SensorGrid> grid = calc::make_sensor_grid(plane, space, diagnostics);
    if (!grid) continue;
    const std::string words = radiance::sum_words(*grid);
    if (!words.empty()) changed.push_back(words);
    ids.push_back(plane.id);
    grids.push_back(std::move(*grid));
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return grids;
}

// Null and no error if the id is "".
const calc::LightScene* find_scene(const calc::Project& project, const std::string& id,
                                   calc::Diagnostics& diagnostics) {
  if (id.empty()) return nullptr;
  std::vector<std::string_view> ids;
  for (const calc::LightScene& scene : project.scenes) {
    if (scene.id == id) return &scene;
    ids.push_back(scene.id);
  }
  diagnostics.report(DiagnosticId::output_not_possible, {project.path, 0, 0},
                     ids.empty()
                         ? fmt::format("--scene '{}': the project has no scene", id)
                         : fmt::format("--scene: the project has no scene '{}'; known: {}{}", id,
                                       calc::join_choices(ids), calc::suggestion(id, ids)));
  return nullptr;
}

std::vector<ExportedFile> radiance_files(const calc::Project& project, const calc::Space& space,
                                         const std::string& scene_id,
                                         std::vector<std::string>& notes,
                                         calc::Diagnostics& diagnostics) {
  const calc::LightScene* levels = find_scene(project, scene_id, diagnostics);
  if (diagnostics.has_errors()) return {};
  std::vector<std::string> ids, changed;
  const std::vector<calc::SensorGrid> grids = grids_of(space, ids, changed, diagnostics);
  std::vector<radiance::Plane> planes;
  for (std::size_t p = 0; p < grids.size(); ++p) planes.push_back({ids[p], &grids[p]});
  const calc::PreparedScene scene = calc::prepare_scene(project, space);
  if (diagnostics.has_errors()) return {};
  if (planes.empty() || scene.luminaires.empty()) {
    diagnostics.report(DiagnosticId::output_not_possible, space.where,
                       fmt::format("space '{}' has no {} to export", space.id,
                                   planes.empty() ? "plane of illuminance" : "luminaire"));
    return {};
  }
  radiance::LightFiles lights = radiance::write_lights(
      scene,
      levels == nullptr ? std::vector<std::pair<std::string, double>>() : levels->level_of_group);
  if (lights.data.empty()) {
    diagnostics.report(
        DiagnosticId::output_not_possible, space.where,
        fmt::format("space '{}' has no luminaire with light to export{}", space.id,
                    levels == nullptr ? "" : fmt::format(" in scene '{}'", levels->id)));
    return {};
  }
  changed.insert(changed.end(), lights.changed.begin(), lights.changed.end());
  notes = changed;
  const radiance::Light light{levels, std::move(changed)};
  std::size_t all = 0;
  for (const calc::Space& each : project.spaces) all += each.planes.size();
  const bool is_partial = planes.size() < all;
  std::vector<ExportedFile> files = {
      {"materials.rad", radiance::write_materials(scene)},
      {"surfaces.rad", radiance::write_surfaces(scene)},
      {"luminaires.rad", std::move(lights.scene)},
      {"luxgate.cal", radiance::kFunctions},
      {"points.txt", radiance::write_points(planes)},
      {"weights.txt", radiance::write_weights(planes)},
      {"points.csv", radiance::write_point_table(planes)},
      {"run.sh", radiance::write_script(scene, light, is_partial)},
      {"README.md", radiance::write_readme(project, space, scene, planes, is_partial, light)}};
  for (radiance::LightFiles::Data& data : lights.data) {
    files.push_back({std::move(data.name), std::move(data.text)});
  }
  return files;
}

// "" = the file can be written.
std::string obstacle(const ExportOptions& options, const std::string& path,
                     const RecordingReader& inputs) {
  for (const std::string& input : inputs.paths()) {
    if (path_identity(input) == path_identity(path)) {
      return fmt::format("'{}' was read as an input and is not overwritten", path);
    }
  }
  std::error_code ignored;
  if (!options.overwrites && fs::exists(path, ignored)) {
    return fmt::format("'{}' exists already; --force replaces files of an earlier export", path);
  }
  return writability(path);
}

// "" = every file can be written.
std::string obstacle(const ExportOptions& options, const std::vector<ExportedFile>& files,
                     const RecordingReader& inputs) {
  for (const ExportedFile& file : files) {
    const std::string path = (fs::path(options.output) / file.name).string();
    const std::string problem = obstacle(options, path, inputs);
    if (!problem.empty()) return problem;
  }
  return "";
}

// "" after an error.
std::string export_project(const ExportOptions& options, const RecordingReader& files,
                           calc::Diagnostics& diagnostics) {
  const std::optional<calc::Project> project =
      check::load_judged_project(options.project, files, options.rule_files, diagnostics);
  if (!project) return "";
  const bool is_radiance = options.target == kRadiance;
  std::vector<const calc::Space*> spaces;
  if (is_radiance || !options.space.empty()) {
    spaces = {find_chosen_space(*project, options.space, diagnostics)};
    if (spaces.front() == nullptr) return "";
  } else {
    for (const calc::Space& space : project->spaces) spaces.push_back(&space);
  }
  if (!is_radiance) {
    // Light takes a while: what stands in the way of the files is told before.
    std::vector<ExportedFile> wanted;
    for (const auto& [id, name] : gltf_names(spaces)) wanted.push_back({name, ""});
    if (const std::string problem = obstacle(options, wanted, files); !problem.empty()) {
      diagnostics.report(DiagnosticId::output_not_possible, {}, problem);
      return "";
    }
  }
  std::vector<std::string> notes;
  const std::vector<ExportedFile> exported =
      is_radiance ? radiance_files(*project, *spaces.front(), options.scene, notes, diagnostics)
                  : gltf_files({options.seed, options.jobs}, *project, spaces, notes, diagnostics);
  if (exported.empty()) return "";
  std::string problem = obstacle(options, exported, files);
  for (const ExportedFile& file : exported) {
    if (!problem.empty()) break;
    const std::string path = (fs::path(options.output) / file.name).string();
    const std::string failure = report::write_file_atomically(path, file.text);
    if (!failure.empty()) problem = fmt::format("cannot write '{}': {}", path, failure);
    if (file.name == "run.sh" && failure.empty()) {
      std::error_code ignored;  // without it the script runs by 'sh run.sh'
      fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                      fs::perm_options::add, ignored);
    }
  }
  if (!problem.empty()) {
    diagnostics.report(DiagnosticId::output_not_possible, {}, problem);
    return "";
  }
  std::string text = fmt::format("Wrote {} file{} into {}.", exported.size(),
                                 exported.size() == 1 ? "" : "s", options.output);
  text += is_radiance ? fmt::format(" Next: {}\n", (fs::path(options.output) / "run.sh").string())
                      : std::string("\n");
  const char* head = is_radiance ? "Not as in luxgate" : "Note";
  for (const std::string& note : notes) {
    text += fmt::format("{}: {}\n", head, report::printable(note));
  }
  return text;
}

// Empty after an error.
std::optional<std::string> read_input(const std::string& path, const calc::FileReader& files,
                                      calc::Diagnostics& diagnostics) {
  calc::FileContent content = files.read(path);
  if (content.ok()) return std::move(content.bytes);
  diagnostics.report(DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
  return std::nullopt;
}

// Results into a model. The text is "" after an error.
std::string export_ifc(const ExportOptions& options, const RecordingReader& files, bool& is_all,
                       calc::Diagnostics& diagnostics) {
  const std::optional<std::string> model = read_input(options.project, files, diagnostics);
  const std::optional<std::string> json = read_input(options.results, files, diagnostics);
  if (!model || !json) return "";
  std::string problem;
  const std::optional<report::Document> result = report::read_json(*json, problem, options.results);
  if (!result) {
    diagnostics.report(DiagnosticId::result_not_readable, {}, options.results, problem);
    return "";
  }
  const std::optional<IfcWithResults> with = ifc_with_results(*model, *result, problem);
  if (!with) {
    diagnostics.report(DiagnosticId::output_not_possible, {options.project, 0, 0}, problem);
    return "";
  }
  problem = obstacle(options, options.output, files);
  if (problem.empty()) {
    problem = report::write_file_atomically(options.output, with->text);
    if (!problem.empty()) problem = fmt::format("cannot write '{}': {}", options.output, problem);
  }
  if (!problem.empty()) {
    diagnostics.report(DiagnosticId::output_not_possible, {}, problem);
    return "";
  }
  is_all = with->is_all;
  std::string text = fmt::format("Wrote {} with the results of {} room{}.\n", options.output,
                                 with->rooms, with->rooms == 1 ? "" : "s");
  for (const std::string& note : with->notes) text += "Note: " + note + "\n";
  return text;
}

}  // namespace

CommandOutcome run_export(const ExportOptions& options, const calc::FileReader& disk) {
  const RecordingReader files(disk);
  calc::Diagnostics diagnostics;
  CommandOutcome outcome;
  bool is_all = true;
  outcome.text = options.target == kIfc ? export_ifc(options, files, is_all, diagnostics)
                                        : export_project(options, files, diagnostics);
  if (!is_all) outcome.code = kNotMet;
  if (outcome.text.empty()) outcome.code = kNotJudged;
  outcome.diagnostics = diagnostics.all();
  return outcome;
}

Command export_command() {
  const auto options = std::make_shared<ExportOptions>();
  Command command = export_syntax(*options);
  command.run = [options](const RunContext&) {
    return print_outcome(run_export(*options, calc::DiskFileReader(options->allowed)));
  };
  return command;
}

}  // namespace cli
