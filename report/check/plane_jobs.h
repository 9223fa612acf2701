#pragma once
// The planes of a space before any light: their points, and whether their requirements can be
// judged on them. check, validate and plan share this.

#include "calc/base/diagnostics.h"
#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/binding/judged_project.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace check {

// A plane to be calculated; without a grid `reason` says why it cannot be computed.
struct PlaneJob {
  const calc::CalcPlane* plane;
  std::vector<rules::Requirement> requirements;  // with the problems of those that do not fit
  std::optional<calc::SensorGrid> grid;
  calc::Message reason;
};

// Returns the jobs of all planes of the space, in order, and then of those whose omission has
// ended. A plane without a grid is an error. day: YYYY-MM-DD, which decides whether stated
// deviations and omissions have ended.
std::vector<PlaneJob> make_plane_jobs(const calc::Space& space, const rules::JudgedProject& loaded,
                                      const std::vector<rules::RulePack>& packs,
                                      std::string_view day, calc::Diagnostics& diagnostics);

// Warns of each <require> that counts and has a problem, whatever the light will be.
void warn_of_unjudged(const std::vector<PlaneJob>& jobs, calc::Diagnostics& diagnostics);

}  // namespace check
