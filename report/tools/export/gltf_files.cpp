#include "report/tools/export/gltf_files.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/radiosity/looks/cutaway.h"
#include "calc/radiosity/looks/surface_light.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "report/shell/output/outputs.h"
#include "report/tools/export/gltf_room.h"
#include "report/tools/pictures/room_pictures.h"
#include "rules/binding/bind.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

// Outlines of the planes that have one, just above what they may lie on.
std::vector<gltf::Outline> outlines_of(const calc::Space& space, const calc::PreparedScene& scene,
                                       std::vector<std::string>& notes,
                                       calc::Diagnostics& diagnostics) {
  constexpr double kLift = 1e-3;  // of the room's diagonal
  std::vector<gltf::Outline> outlines;
  for (const calc::CalcPlane& plane : space.planes) {
    const std::optional<calc::SensorGrid> grid = calc::make_sensor_grid(plane, space, diagnostics);
    if (!grid) continue;
    if (grid->outline_m.empty()) {
      notes.push_back(fmt::format("plane '{}' is a list of points: it has no outline", plane.id));
      continue;
    }
    gltf::Outline outline{plane.id, {}};
    if (grid->route) {
      outline.corner_m = route_outline_m(*grid->route, scene.origin_m);
    } else {
      for (const glm::dvec2& corner : grid->outline_m) {
        outline.corner_m.push_back(grid->origin_m - scene.origin_m + corner.x * grid->u +
                                   corner.y * grid->v);
      }
    }
    const glm::dvec3 lift_m = kLift * scene.extent_m * glm::cross(grid->u, grid->v);
    for (glm::dvec3& corner : outline.corner_m) corner += lift_m;
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

}  // namespace

std::map<std::string, std::string> gltf_names(const std::vector<const calc::Space*>& spaces) {
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
  for (const calc::Space* space : spaces) {
    std::string wanted = safe_name(space->id);
    if (wanted.empty() || wanted.front() == '.') wanted = "room" + wanted;
    std::string stem = wanted;
    for (int i = 2; !taken.insert(calc::ascii_lowered(stem)).second; ++i)
      stem = fmt::format("{}-{}", wanted, i);
    names[space->id] = stem + ".glb";
  }
  return names;
}

std::vector<ExportedFile> gltf_files(const GltfSettings& wanted, const calc::Project& project,
                                     const std::vector<const calc::Space*>& spaces,
                                     std::vector<std::string>& notes,
                                     calc::Diagnostics& diagnostics) {
  std::vector<std::unique_ptr<calc::PreparedScene>> scenes;
  std::vector<gltf::Room> rooms;
  const auto gatherer = calc::make_cpu_gatherer();
  calc::SurfaceLightSettings settings;
  settings.points = 5000;  // nobody waits for it among verdicts
  settings.seed = wanted.seed;
  settings.jobs = wanted.jobs;
  for (const calc::Space* space : spaces) {
    auto scene = std::make_unique<calc::PreparedScene>(calc::prepare_scene(project, *space));
    gltf::Room room{space->id, space->name, scene.get(), {}, {}};
    if (scene->triangle.empty()) {
      room.light.problem = calc::say<calc::Sentence::model_no_surfaces>();
    } else if (scene->triangle.size() > settings.most_points) {
      room.light.problem =
          calc::say<calc::Sentence::model_too_large>(scene->triangle.size(), settings.most_points);
    } else {
      const calc::Tracer tracer(*scene);
      room.light = calc::light_surfaces(*scene, calc::sides_from_everywhere(tracer, opens(*space)),
                                        settings, *gatherer);
    }
    if (!room.light.problem.empty()) {
      notes.push_back(
          fmt::format("space '{}' is missing: {}", space->id, room.light.problem.english()));
      continue;
    }
    room.planes = outlines_of(*space, *scene, notes, diagnostics);
    notes.push_back(fmt::format("the light of space '{}' has a sampling error of {:.1f} %",
                                space->id, 100.0 * room.light.error_share));
    scenes.push_back(std::move(scene));
    rooms.push_back(std::move(room));
  }
  if (diagnostics.has_errors()) return {};
  if (rooms.empty()) {
    diagnostics.report(
        calc::DiagnosticId::output_not_possible, {},
        notes.empty() ? std::string("there is no model: the project has no room and no surface")
                      : fmt::format("there is no model: {}", fmt::join(notes, "; ")));
    return {};
  }
  const auto is_told = [](const calc::Diagnostic& one) {
    return one.id == calc::DiagnosticId::maintenance_not_stated;
  };
  const std::vector<calc::Diagnostic>& told = diagnostics.all();
  if (std::none_of(told.begin(), told.end(), is_told))
    rules::report_unstated_maintenance(project, diagnostics);
  const report::ColourScale scale = gltf::common_scale(rooms);
  const std::map<std::string, std::string> names = gltf_names(spaces);
  std::vector<ExportedFile> files;
  for (const gltf::Room& room : rooms)
    files.push_back({names.at(room.id), gltf::write_glb(room, scale)});
  return files;
}

}  // namespace cli
