#pragma once
// Plans a check without running it.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/base/message.h"
#include "calc/forecast/device_cost.h"
#include "calc/forecast/scene_plan.h"
#include "report/check/selection.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace check {

struct SpacePlan {
  std::string id, name;
  std::size_t triangles = 0;
  calc::ScenePlan plan;
  std::vector<std::string> rule_of_grid;  // of plan.planes: how its points were chosen
  std::vector<calc::Message> notes;       // zones of workplaces that are not made
  std::string obstacle;  // id of the body that keeps the space from being convex; may be empty
};

struct ProjectPlan {
  std::string path, name;
  bool is_planned = false;  // false: errors; spaces may be missing
  std::vector<calc::Diagnostic> diagnostics;
  std::vector<SpacePlan> spaces;
};

// Reads everything that a check reads. A plane without points is an error; the others are planned.
// What will not be judged, whatever the light, is a warning, and so are numbers of one public
// source where that is asked for. day: YYYY-MM-DD, see day_of().
ProjectPlan plan_project(const std::string& path, const calc::FileReader& files,
                         const std::vector<rules::RulePack>& packs,
                         const calc::RadiositySettings& settings, std::string_view day,
                         const calc::Budget& budget = {}, const Selection& selection = {},
                         bool warns_of_one_source = false);

// Returns a plan for each project.
std::vector<ProjectPlan> plan_projects(const std::vector<std::string>& paths,
                                       const calc::FileReader& files,
                                       const std::vector<rules::RulePack>& packs,
                                       const calc::RadiositySettings& settings,
                                       std::string_view day, const calc::Budget& budget = {},
                                       const Selection& selection = {},
                                       bool warns_of_one_source = false);

// Returns the work of the first sampling rounds of all planned projects, with their shadow maps, on
// all threads of the machine: the choice of `auto` must not depend on settings.jobs, as no result
// does.
calc::DeviceWork first_look_work(const std::vector<ProjectPlan>& projects,
                                 const calc::RadiositySettings& settings);

}  // namespace check
