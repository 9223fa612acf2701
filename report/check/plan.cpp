#include "report/check/plan.h"

#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "report/check/load_judged_project.h"
#include "report/check/plane_jobs.h"
#include "report/text/one_source_note.h"
#include "rules/binding/judged_project.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace check {
namespace {

std::string grid_text(const calc::SensorGrid& grid) {
  if (grid.columns == 0) return grid.rule.english();
  if (grid.route) {
    return fmt::format("{}; {} stations and {} rows on {:.4g} m x {:.3g} m", grid.rule.english(),
                       grid.columns, grid.rows, calc::route_length_m(grid.route->line),
                       grid.route->line.width_m);
  }
  return fmt::format("{}; cells of {:.3g} x {:.3g} m in {} columns and {} rows, margin {:.3g} m",
                     grid.rule.english(), grid.spacing_u_m, grid.spacing_v_m, grid.columns,
                     grid.rows, grid.margin_m);
}

// jobs: of the space.
SpacePlan plan_space(const calc::Project& project, const calc::Space& space,
                     const std::vector<PlaneJob>& jobs, const calc::RadiositySettings& settings) {
  std::vector<std::string> rule_of_grid;
  std::vector<calc::PlaneTask> tasks;
  for (const PlaneJob& job : jobs) {
    if (!job.grid) continue;
    rule_of_grid.push_back(grid_text(*job.grid));
    tasks.push_back({job.plane->id, &*job.grid});
  }

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
                         const calc::RadiositySettings& settings, std::string_view day,
                         const calc::Budget& budget, const Selection& selection,
                         bool warns_of_one_source) {
  ProjectPlan plan;
  plan.path = path;
  calc::Diagnostics diagnostics;
  std::vector<calc::Message> one_source;
  if (auto loaded = load_in_budget(path, files, packs, settings.replicates, budget, diagnostics)) {
    select(selection, loaded->judged, diagnostics);
    const rules::JudgedProject& judged = loaded->judged;
    const calc::Project& project = judged.project;
    plan.name = project.name;
    if (warns_of_one_source) one_source = one_source_rows(judged);
    for (const calc::Space& space : project.spaces) {
      const std::vector<PlaneJob> jobs = make_plane_jobs(space, judged, packs, day, diagnostics);
      warn_of_unjudged(jobs, diagnostics);
      plan.spaces.push_back(plan_space(project, space, jobs, settings));
    }
  }
  plan.is_planned = !diagnostics.has_errors();
  plan.diagnostics = diagnostics.all();
  report::warn_of_one_source(one_source, path, plan.diagnostics);
  return plan;
}

std::vector<ProjectPlan> plan_projects(const std::vector<std::string>& paths,
                                       const calc::FileReader& files,
                                       const std::vector<rules::RulePack>& packs,
                                       const calc::RadiositySettings& settings,
                                       std::string_view day, const calc::Budget& budget,
                                       const Selection& selection, bool warns_of_one_source) {
  std::vector<ProjectPlan> plans;
  for (const std::string& path : paths) {
    plans.push_back(
        plan_project(path, files, packs, settings, day, budget, selection, warns_of_one_source));
  }
  return plans;
}

calc::DeviceWork first_look_work(const std::vector<ProjectPlan>& projects,
                                 const calc::RadiositySettings& settings) {
  calc::DeviceWork sum;
  sum.threads = calc::thread_count({});
  for (const ProjectPlan& project : projects) {
    for (const SpacePlan& space : project.spaces) {
      sum.add(space.plan.first_look, space.plan.workload, settings, space.plan.threads);
    }
  }
  return sum;
}

}  // namespace check
