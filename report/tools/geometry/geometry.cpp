#include "report/tools/geometry/geometry.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/xml_encoding.h"
#include "calc/meshes/gbxml.h"
#include "calc/meshes/mesh_builder.h"
#include "calc/meshes/mesh_file.h"
#include "calc/project/project_xml.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/reading/project_files.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"
#include "rules/verdict/outcome.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace cli {
namespace {

// Below it a model is furniture rather than a room, and open edges mean nothing.
constexpr double kRoomShare = 0.3;

// What a model is for.
enum class ModelUse : std::uint8_t {
  other,
  room,           // one sheet around its inside
  between_solids  // a room, too, whose walls have two faces
};

SurfaceReport report_of(const calc::SurfaceModel& model, ModelUse use) {
  SurfaceReport surface;
  surface.is_room = use != ModelUse::other;
  surface.findings = calc::check_surface(model);
  surface.escape = measure_escape(model, surface.findings.bounds_m, use == ModelUse::room);
  return surface;
}

// The rooms of a building; each model has its own rays, so that they may run at the same time.
std::vector<SurfaceReport> reports_of(const std::vector<calc::SurfaceModel>& models,
                                      const std::vector<ModelUse>& uses) {
  std::vector<SurfaceReport> surfaces(models.size());
  tbb::parallel_for(std::size_t{0}, models.size(),
                    [&](std::size_t i) { surfaces[i] = report_of(models[i], uses[i]); });
  return surfaces;
}

void warn_about_leaks(const SurfaceReport& surface, const std::string& name,
                      const calc::SourceLocation& where, calc::Diagnostics& diagnostics) {
  const calc::Estimate& share = surface.escape.share;
  const bool should_be_closed = surface.is_room || surface.escape.inside_share >= kRoomShare;
  if (!should_be_closed || surface.escape.points == 0 || share.value == 0.0) return;
  diagnostics.report(calc::DiagnosticId::surface_leaks, where, 100.0 * share.value, name,
                     100.0 * share.low, 100.0 * share.high);
}

// "" for those that are fixed by the file's format; empty, with an error, if they are not known.
struct Axes {
  std::string units, up;
};
std::optional<Axes> axes_for(calc::MeshFormat format, const GeometryOptions& options,
                             const std::string& path, calc::Diagnostics& diagnostics) {
  if (calc::has_fixed_units(format)) return Axes{"m", "y"};
  const std::string_view name = calc::name_of(format);
  const calc::SourceLocation where{path, 0, 0};
  if (options.mesh_units.empty()) {
    diagnostics.report(calc::DiagnosticId::geometry_needs, where, name, "their unit",
                       "--units m, cm, mm, in or ft");
  }
  if (options.mesh_up.empty()) {
    diagnostics.report(calc::DiagnosticId::geometry_needs, where, name, "what is up",
                       "--up z or y");
  }
  if (options.mesh_units.empty() || options.mesh_up.empty()) return std::nullopt;
  return Axes{options.mesh_units, options.mesh_up};
}

double metres_per_unit(const std::string& unit) {
  const calc::Names& names = calc::kUnitsType.words;
  return calc::metres_per_unit(
      static_cast<std::size_t>(std::find(names.begin(), names.end(), unit) - names.begin()));
}

void examine_mesh(const std::string& bytes, const calc::FileReader& files,
                  const GeometryOptions& options, calc::Diagnostics& diagnostics,
                  GeometryReport& report) {
  const std::string folder = report.path.substr(0, report.path.rfind('/') + 1);
  const calc::SideFiles side_files = [&](const std::string& name) -> std::optional<std::string> {
    calc::FileContent content = files.read(folder + name);
    if (content.ok()) return std::move(content.bytes);
    diagnostics.report(calc::DiagnosticId::file_not_readable,
                       calc::SourceLocation{report.path, 0, 0}, folder + name, content.error);
    return std::nullopt;
  };
  const auto mesh = calc::parse_mesh_file(bytes, report.path, side_files, diagnostics);
  if (!mesh) return;
  const std::optional<Axes> axes = axes_for(mesh->format, options, report.path, diagnostics);
  if (!axes) return;
  report.kind = calc::name_of(mesh->format);
  report.units = axes->units;
  report.up = axes->up;
  const calc::SourceLocation where{report.path, 0, 0};
  const calc::SurfaceModel model =
      calc::surface_of(*mesh, metres_per_unit(axes->units), axes->up == "y");
  report.surfaces.push_back(report_of(model, ModelUse::other));
  calc::warn_about_surface(report.surfaces.back().findings, where, diagnostics);
  warn_about_leaks(report.surfaces.back(), report.path, where, diagnostics);
}

ModelUse use_of(const calc::Space& space) {
  if (!space.shell && space.surfaces_file.empty()) return ModelUse::other;
  const bool has_shell =
      std::any_of(space.bodies.begin(), space.bodies.end(),
                  [&](const calc::Body& body) { return body.id == space.id + ".shell"; });
  return space.is_from_mesh && !has_shell ? ModelUse::between_solids : ModelUse::room;
}

void examine_project(const calc::FileReader& files, calc::Diagnostics& diagnostics,
                     GeometryReport& report) {
  const std::optional<calc::Project> project = calc::load_project(files, report.path, diagnostics);
  if (!project) return;
  report.kind = "project";
  std::vector<calc::SurfaceModel> models;
  std::vector<ModelUse> uses;
  for (const calc::Space& space : project->spaces) {
    models.push_back(calc::surface_of(*project, space));
    uses.push_back(use_of(space));
  }
  report.surfaces = reports_of(models, uses);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const calc::Space& space = project->spaces[i];
    SurfaceReport& surface = report.surfaces[i];
    surface.id = space.id;
    surface.name = space.name;
    for (const calc::Message& note : space.notes) surface.notes.push_back(note.english());
    calc::warn_about_surface(surface.findings, space.where, diagnostics);
    if (surface.is_room) warn_about_leaks(surface, space.id, space.where, diagnostics);
  }
}

calc::SurfaceModel surface_of(const calc::GbxmlRoom& room) {
  calc::SurfaceModel model;
  calc::NameList types;
  for (const calc::GbxmlPart& part : room.part) {
    const auto first = static_cast<std::uint32_t>(model.vertex_m.size());
    const auto object = static_cast<std::uint32_t>(model.object_name.size());
    model.object_name.push_back(part.id);
    model.vertex_m.insert(model.vertex_m.end(), part.vertex_m.begin(), part.vertex_m.end());
    for (const glm::uvec3& triangle : part.triangle) model.triangle.push_back(triangle + first);
    model.object_of.resize(model.triangle.size(), object);
    model.material_of.resize(model.triangle.size(), types.index_of(part.type));
  }
  model.material_name = types.names();
  model.polygons_mended = room.polygons_mended;
  model.polygons_left_out = room.polygons_left_out;
  model.area_left_out_m2 = room.area_left_out_m2;
  return model;
}

// Surface types stand for materials.
void examine_gbxml(std::string bytes, calc::Diagnostics& diagnostics, GeometryReport& report) {
  const std::optional<calc::GbxmlBuilding> building =
      calc::parse_gbxml(std::move(bytes), report.path, diagnostics);
  if (!building) return;
  report.kind = "gbxml";
  const calc::SourceLocation where{report.path, 0, 0};
  std::vector<calc::SurfaceModel> models;
  for (const calc::GbxmlSpace& space : building->space) {
    calc::Diagnostics of_room;  // a space without surfaces is no error of the file
    const std::optional<calc::GbxmlRoom> room =
        calc::gbxml_room(*building, space.id, where, of_room);
    models.push_back(room ? surface_of(*room) : calc::SurfaceModel());
    if (!room) continue;
    for (const calc::Diagnostic& d : of_room.all()) report.diagnostics.push_back(d);
  }
  report.surfaces = reports_of(models, std::vector<ModelUse>(models.size(), ModelUse::room));
  for (std::size_t i = 0; i < models.size(); ++i) {
    const calc::GbxmlSpace& space = building->space[i];
    SurfaceReport& surface = report.surfaces[i];
    surface.id = space.id;
    surface.name = space.name;
    calc::warn_about_surface(surface.findings, where, diagnostics);
    warn_about_leaks(surface, space.id, where, diagnostics);
  }
}

}  // namespace

GeometryReport examine_geometry(const std::string& path, const calc::FileReader& files,
                                const GeometryOptions& options) {
  GeometryReport report;
  report.path = path;
  calc::Diagnostics diagnostics;
  calc::FileContent content = files.read(path);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, calc::SourceLocation{path, 0, 0},
                       path, content.error);
  } else if (calc::is_gbxml(content.bytes)) {
    examine_gbxml(std::move(content.bytes), diagnostics, report);
  } else if (calc::looks_like_xml(content.bytes)) {
    examine_project(files, diagnostics, report);
  } else {
    examine_mesh(content.bytes, files, options, diagnostics, report);
  }
  const std::vector<calc::Diagnostic>& found = diagnostics.all();
  report.diagnostics.insert(report.diagnostics.end(), found.begin(), found.end());
  return report;
}

namespace {

ExitCode run_geometry(const GeometryOptions& options) {
  using rules::Outcome;
  const calc::DiskFileReader files;
  std::vector<GeometryReport> reports;
  Outcome outcome = Outcome::nothing_asked;
  for (const std::string& path : options.files) {
    reports.push_back(examine_geometry(path, files, options));
    const GeometryReport& report = reports.back();
    print_diagnostics(report.diagnostics, false);
    if (!report.is_readable()) outcome = graver(outcome, Outcome::not_judged);
    if (options.strict && !report.diagnostics.empty()) outcome = graver(outcome, Outcome::fail);
  }
  const std::string text =
      options.as_json ? render_geometry_json(reports) : render_geometry_text(reports);
  return print_outcome({exit_code_of(outcome), text, {}});
}

}  // namespace

Command geometry_syntax(GeometryOptions& options) {
  Command command{"geometry",
                  "Print what is in mesh files and projects, and whether rooms are closed"};
  command.places = {{"files", "FILE",
                     "Mesh files (OBJ, glTF, GLB, STL, PLY), gbXML files or projects",
                     &options.files}};
  command.options = {
      {"--units", "UNIT",
       "Set the unit of OBJ, STL and PLY files: m, cm, mm, in or ft; they need it",
       choice<std::string>(options.mesh_units,
                           {{"m", "m"}, {"cm", "cm"}, {"mm", "mm"}, {"in", "in"}, {"ft", "ft"}})},
      {"--up", "AXIS", "Set the vertical axis of OBJ, STL and PLY files: z or y; they need it",
       choice<std::string>(options.mesh_up, {{"z", "z"}, {"y", "y"}})},
      {"--strict", "", "End with exit code 1 if there is a warning", &options.strict}};
  add(command.options, text_or_json_options(options.as_json));
  command.examples = {{"luxgate geometry hall.glb", "Whether its surfaces are closed"},
                      {"luxgate geometry part.stl --units mm --up y", "Of a file without units"}};
  command.exit_codes = {
      {0, "readable"}, {1, "there are warnings, with --strict"}, {2, "at least one error"}};
  return command;
}

Command geometry_command() {
  const auto options = std::make_shared<GeometryOptions>();
  Command command = geometry_syntax(*options);
  command.run = [options](const RunContext&) { return run_geometry(*options); };
  return command;
}

}  // namespace cli
