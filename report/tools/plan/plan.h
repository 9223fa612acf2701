#pragma once
// `luxgate plan`: the work of a check, in words and as JSON.

#include "calc/base/budget.h"
#include "report/check/drawing_device.h"
#include "report/check/plan.h"
#include "report/shell/command/command.h"
#include "report/shell/options/project_options.h"
#include "report/shell/options/sandbox.h"
#include "report/shell/options/set_option.h"
#include "report/shell/options/work_options.h"
#include "report/shell/output/warning_tally.h"

#include <string>
#include <vector>

namespace cli {

struct PlanOptions {
  ProjectOptions input;
  std::vector<check::SetValue> set;
  calc::Budget budget;
  check::Selection selection;
  calc::RadiositySettings radiosity;
  check::BackendRequest backend;
  bool as_json = false;
  bool as_units = false;  // as units that machines can share
  StrictWarnings strict;
  bool quiet = false;
  SandboxMode sandbox = SandboxMode::automatic;
  std::string date;  // a moment by SOURCE_DATE_EPOCH; "" = the clock's
};

Command plan_syntax(PlanOptions& options);
Command plan_command();

// Returns the text. pictures: work for pictures of rooms, if a check makes some.
std::string render_plan_text(const std::vector<check::ProjectPlan>& projects,
                             const calc::RadiositySettings& settings,
                             const check::BackendChoice& backend,
                             const check::DrawingChoice& pictures);
std::string render_plan_json(const std::vector<check::ProjectPlan>& projects,
                             const calc::RadiositySettings& settings,
                             const check::BackendChoice& backend,
                             const check::DrawingChoice& pictures);

// Returns, for --explain-cost, the plan's prediction for the sampling rounds that were taken, and
// their real times. solution: of these tasks.
std::string explain_cost(const std::string& path, const std::string& space_id,
                         const calc::PreparedScene& scene,
                         const std::vector<calc::PlaneTask>& tasks,
                         const calc::RadiositySettings& settings,
                         const calc::SpaceSolution& solution);

}  // namespace cli
