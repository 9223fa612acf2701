#pragma once
// Reads what a project requires of the rooms of its buildings together.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/judge_buildings.h"

#include <vector>

namespace rules {

// Returns the requirements in file order. Reports anything not understood or not about rooms
// together; such requirements are missing from the result, which should then not be judged.
std::vector<BuildingQuestion> bind_buildings(const calc::Project& project,
                                             const std::vector<RulePack>& packs,
                                             calc::Diagnostics& diagnostics);

}  // namespace rules
