#pragma once
// Whether a plane is what a standard's number is about. A limit of a rule pack means points of a
// certain kind: so many, at such a height, facing such a way. On other points the number says
// nothing, and must not pass.

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

// requirements: of the plane. Those of a rule pack get their `deviations`, and a `problem`, which
// keeps them from being judged, if one is not stated or its last day is over; or if they are about
// maintained light and no maintenance factor is stated. A plane that the pack says nothing about
// fits. Points that are left out are named in the note of every requirement.
void check_applicability(const ApplicabilityContext& context,
                         std::vector<Requirement>& requirements);

// Returns what to say of a task that is too small for its room: the project draws the task, so a
// small task can be put where the light is good. No rule forbids that, but readers of the verdict
// must see it. The band inside the margin counts as task. Empty for larger planes and point lists.
calc::Message small_task_words(const calc::CalcPlane& plane, const calc::SensorGrid& grid);

}  // namespace rules
