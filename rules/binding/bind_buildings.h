#pragma once
// What a project asks of the rooms of its buildings together.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/judge_buildings.h"

#include <vector>

namespace rules {

// In the order of the file. Everything that is not understood is reported, and what is not about
// rooms together; what has an error is left out, and the result should then not be judged.
std::vector<BuildingQuestion> bind_buildings(const calc::Project& project,
                                             const std::vector<RulePack>& packs,
                                             calc::Diagnostics& diagnostics);

}  // namespace rules
