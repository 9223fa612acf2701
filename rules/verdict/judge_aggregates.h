#pragma once
// Aggregates and classes of rule packs against the findings of a project.

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

// In order of the packs, their aggregates and then their classes, and of the planes; one finding
// for every plane, room or project (see AggregateOver) that one of the checks is asked for in.
//
// A check that is asked for in several places is met if it is met in each. One that the row
// requires nothing for is left out; one that nothing asks for is not judged. An aggregate passes or
// fails only if it would whatever its open members turn out to be; else it is not judged if one of
// them is not, or undecided. What is waived counts as met only for is_waived, never for the
// verdict.
//
// Classes are advice: what they are made of counts by itself. Better and worse classes than the one
// asked for are judged from the same intervals.
std::vector<AggregateFinding> judge_aggregates(const std::vector<JudgedPlane>& planes,
                                               const std::vector<RulePack>& packs);

}  // namespace rules
