#pragma once
// Checks whether a plane is of the kind that a standard's number is about: so many points, at such
// a height, facing such a way. For other points the number says nothing, and they must not pass.

#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/rule_pack.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

struct ApplicabilityContext {
  const calc::Project& project;
  const calc::Space& space;
  const calc::CalcPlane& plane;  // of the space
  const calc::SensorGrid& grid;  // of the plane
  const std::vector<RulePack>& packs;
  std::string_view today;                        // YYYY-MM-DD, by which stated deviations end
  std::span<const Requirement> of_project = {};  // of all planes: what is beside this one
};

// Checks the requirements of the plane. Those of a rule pack get their `deviations`. They get a
// `problem`, which keeps them from being judged, if a deviation is not stated or its last day is
// over, or if they need maintained light and no maintenance factor is stated. A plane on which the
// pack says nothing fits. The note of every requirement names omitted points.
void check_applicability(const ApplicabilityContext& context,
                         std::vector<Requirement>& requirements);

// Returns what to say of a task that is too small for its room: the project draws the task, so a
// small task can be put where the light is good. No rule forbids that, but readers of the verdict
// must see it. The band inside the margin counts as task. Empty for larger planes and point lists.
calc::Message small_task_words(const calc::CalcPlane& plane, const calc::SensorGrid& grid);

}  // namespace rules
