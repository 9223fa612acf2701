#pragma once
// Turns the requirements written in a project into requirements that can be judged.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/rule_pack.h"

#include <string_view>
#include <vector>

namespace rules {

// Returns the requirements of all planes (README.md lists their attributes), in file order of
// planes and of requirements within a plane; rows of a rule pack are expanded in place. Anything
// not understood is an error at its attribute and missing from the result, which should then not be
// judged.
std::vector<Requirement> bind_requirements(const calc::Project& project,
                                           const std::vector<RulePack>& packs,
                                           calc::Diagnostics& diagnostics);

// Reports the errors in the requirements of a project that has errors of its own
// (calc::ReadProject). Only the quantity of the planes is used.
void check_requirements(const calc::Project& project, const std::vector<RulePack>& packs,
                        calc::Diagnostics& diagnostics);

// Returns the requirements that a plane omitted by a workplace would have.
std::vector<Requirement> requirements_of_left_out(const calc::Project& project,
                                                  const calc::Space& space,
                                                  const calc::CalcPlane& plane,
                                                  const std::vector<RulePack>& packs);

// Warns of luminaire types in use that state no maintenance factor: their light is that of a new
// installation.
void report_unstated_maintenance(const calc::Project& project, calc::Diagnostics& diagnostics);

// Returns the requirements of this plane, in their order.
std::vector<Requirement> requirements_of_plane(const std::vector<Requirement>& requirements,
                                               std::string_view plane_id);

}  // namespace rules
