#pragma once
// Judges aggregates and classes of rule packs by the findings of a project.

#include "calc/scene/project.h"
#include "rules/catalogue/aggregate.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/judge.h"

#include <vector>

namespace rules {

// A plane with its findings, waivers already applied. All must outlive the call.
struct JudgedPlane {
  const calc::Space* space;
  const calc::CalcPlane* plane;
  const std::vector<Finding>* findings;
};

// Returns the findings in order of the packs, their aggregates and then their classes, and of the
// planes: one for every plane, room or project (see AggregateOver) that requires one of the checks.
//
// A check required in several places is met if it is met in each. A check is omitted if the row
// requires nothing for it, and not judged if nothing requires it. An aggregate passes or fails only
// if its open members cannot change that; otherwise it is not judged if one of them is not, or else
// undecided. Waived members count as met only for is_waived, never for the verdict.
//
// Classes are advice: their checks count by themselves. Better and worse classes than the required
// one are judged from the same intervals.
std::vector<AggregateFinding> judge_aggregates(const std::vector<JudgedPlane>& planes,
                                               const std::vector<RulePack>& packs);

}  // namespace rules
