#pragma once
// One requirement element of a project: attributes to Requirements.

#include "calc/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/requirement.h"
#include "rules/rule_pack.h"

#include <optional>
#include <vector>

namespace rules {

// What the attributes may refer to.
struct RequirementContext {
  calc::ReceiverKernel kernel;  // of the plane
  const std::vector<calc::LightScene>& scenes;
  const std::vector<RulePack>& packs;
  const calc::CalcPlane* plane = nullptr;  // where it is, which way it faces; null: not known
  calc::DerivedQuantity derived = calc::DerivedQuantity::none;  // of the plane
  std::optional<double> floor_z_m = std::nullopt;               // of the room around it
};

// One requirement, or those of a rule pack's row; empty after an error, which is reported. plane_id
// is not set, and id only if the text gives one.
std::vector<Requirement> read_requirement(const calc::RequirementText& text,
                                          const RequirementContext& context,
                                          calc::Diagnostics& diagnostics);

}  // namespace rules
