#pragma once
// `luxgate plan`: what a check would do, without doing it.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/forecast/scene_plan.h"
#include "report/check/backend.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

struct SpacePlan {
  std::string id, name;
  std::size_t triangles = 0;
  calc::ScenePlan plan;
  std::vector<std::string> rule_of_grid;  // of plan.planes: how its points were chosen
  std::vector<std::string> notes;         // zones of workplaces that are not made
  std::string obstacle;  // id of the body that keeps the space from being convex; may be empty
};

struct ProjectPlan {
  std::string path, name;
  bool is_planned = false;  // false: errors; spaces may be missing
  std::vector<calc::Diagnostic> diagnostics;
  std::vector<SpacePlan> spaces;
};

// Reads everything that a check reads. A plane without points is an error; the others are planned.
ProjectPlan plan_project(const std::string& path, const calc::FileReader& files,
                         const std::vector<rules::RulePack>& packs,
                         const calc::RadiositySettings& settings);

// What the first look at these projects gathers, as far as they are planned.
GatherWork first_look_work(const std::vector<ProjectPlan>& projects);

std::string render_plan_text(const std::vector<ProjectPlan>& projects,
                             const calc::RadiositySettings& settings, const BackendChoice& backend);
std::string render_plan_json(const std::vector<ProjectPlan>& projects,
                             const calc::RadiositySettings& settings, const BackendChoice& backend);

// For --explain-cost: the plan's prediction for the looks that were taken, and what they took.
// solution: of these tasks.
std::string explain_cost(const std::string& path, const std::string& space_id,
                         const calc::PreparedScene& scene,
                         const std::vector<calc::PlaneTask>& tasks,
                         const calc::RadiositySettings& settings,
                         const calc::SpaceSolution& solution);

}  // namespace cli
