#include "report/check/plan.h"

#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "rules/binding/judged_project.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace check {
namespace {

std::string grid_text(const calc::SensorGrid& grid) {
  if (grid.columns == 0) return grid.rule;
  if (grid.route) {
    return fmt::format("{}; {} stations and {} rows on {:.4g} m x {:.3g} m", grid.rule,
                       grid.columns, grid.rows, calc::route_length_m(grid.route->line),
                       grid.route->line.width_m);
  }
  return fmt::format("{}; cells of {:.3g} x {:.3g} m in {} columns and {} rows, margin {:.3g} m",
                     grid.rule, grid.spacing_u_m, grid.spacing_v_m, grid.columns, grid.rows,
                     grid.margin_m);
}

SpacePlan plan_space(const calc::Project& project, const calc::Space& space,
                     const calc::RadiositySettings& settings, calc::Diagnostics& diagnostics) {
  std::vector<calc::SensorGrid> grids;
  std::vector<const calc::CalcPlane*> planes;
  for (const calc::CalcPlane& plane : space.planes) {
    std::optional<calc::SensorGrid> grid = calc::make_sensor_grid(plane, space, diagnostics);
    if (!grid) continue;
    grids.push_back(std::move(*grid));
    planes.push_back(&plane);
  }
  std::vector<std::string> rule_of_grid;
  for (const calc::SensorGrid& grid : grids) rule_of_grid.push_back(grid_text(grid));
  std::vector<calc::PlaneTask> tasks;
  for (std::size_t p = 0; p < planes.size(); ++p) tasks.push_back({planes[p]->id, &grids[p]});

  const calc::PreparedScene scene = calc::prepare_scene(project, space);
  SpacePlan result;
  result.id = space.id;
  result.name = space.name;
  result.triangles = scene.triangle.size();
  result.plan = calc::make_scene_plan(scene, tasks, settings);
  result.rule_of_grid = std::move(rule_of_grid);
  result.notes = space.notes;
  for (const calc::SkipDecision& decision : result.plan.skips) {
    if (decision.body) result.obstacle = space.bodies[*decision.body].id;
  }
  return result;
}

}  // namespace

ProjectPlan plan_project(const std::string& path, const calc::FileReader& files,
                         const std::vector<rules::RulePack>& packs,
                         const calc::RadiositySettings& settings) {
  ProjectPlan plan;
  plan.path = path;
  calc::Diagnostics diagnostics;
  if (const auto judged = rules::load_judged_project(files, path, packs, diagnostics)) {
    const calc::Project& project = judged->project;
    plan.name = project.name;
    for (const calc::Space& space : project.spaces) {
      plan.spaces.push_back(plan_space(project, space, settings, diagnostics));
    }
  }
  plan.is_planned = !diagnostics.has_errors();
  plan.diagnostics = diagnostics.all();
  return plan;
}

std::vector<ProjectPlan> plan_projects(const std::vector<std::string>& paths,
                                       const calc::FileReader& files,
                                       const std::vector<rules::RulePack>& packs,
                                       const calc::RadiositySettings& settings) {
  std::vector<ProjectPlan> plans;
  for (const std::string& path : paths) {
    plans.push_back(plan_project(path, files, packs, settings));
  }
  return plans;
}

GatherWork first_look_work(const std::vector<ProjectPlan>& projects) {
  GatherWork sum;
  for (const ProjectPlan& project : projects) {
    for (const SpacePlan& space : project.spaces) {
      sum.connections += space.plan.first_look.work.connection_rays;
      sum.vertices += space.plan.first_look.work.pool_rays;  // one at the end of each, at most
      sum.triangles += static_cast<double>(space.triangles);
    }
  }
  return sum;
}

}  // namespace check
