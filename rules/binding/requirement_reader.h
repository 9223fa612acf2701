#pragma once
// Reads one requirement element of a project into Requirements. requirement_attributes.h lists the
// attributes and their values.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <vector>

namespace rules {

// Everything that the attributes may refer to.
struct RequirementContext {
  calc::ReceiverKernel kernel;  // of the plane
  const std::vector<calc::LightScene>& scenes;
  const std::vector<RulePack>& packs;
  const calc::Space* space = nullptr;                           // around it; null: not known
  calc::DerivedQuantity derived = calc::DerivedQuantity::none;  // of the plane
  std::string_view usual_role = "";                             // of the plane, see there
  bool is_quantity_known = true;  // false: after an error in the plane, so that its kernel and
                                  // `derived` forbid nothing
  calc::SpecialPlace special = calc::SpecialPlace::none;  // of the plane, as a workplace says
};

// Returns one requirement, or those of a rule pack's row; empty after an error. All errors of the
// element are reported. plane_id is not set, and id only if the text gives one.
std::vector<Requirement> read_requirement(const calc::RequirementText& text,
                                          const RequirementContext& context,
                                          calc::Diagnostics& diagnostics);

}  // namespace rules
