#pragma once
// Requirements as written in a project, made into requirements that can be judged.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/rule_pack.h"

#include <string_view>
#include <vector>

namespace rules {

// Reads the attributes of every plane's requirements; README.md lists them. Planes in file order,
// requirements in file order within a plane, rows of a rule pack expanded in place. Everything that
// is not understood is an error with the attribute's location; what has an error is left out of the
// result, which should then not be judged.
std::vector<Requirement> bind_requirements(const calc::Project& project,
                                           const std::vector<RulePack>& packs,
                                           calc::Diagnostics& diagnostics);

// Of a project that has errors of its own (calc::ReadProject): reports those of its requirements,
// too. Nothing is taken from planes but their quantity.
void check_requirements(const calc::Project& project, const std::vector<RulePack>& packs,
                        calc::Diagnostics& diagnostics);

// What would be asked of a plane that a workplace leaves out.
std::vector<Requirement> requirements_of_left_out(const calc::Project& project,
                                                  const calc::Space& space,
                                                  const calc::CalcPlane& plane,
                                                  const std::vector<RulePack>& packs);

// Warns of types of luminaires in use that state no maintenance factor: their light is that of a
// new installation.
void report_unstated_maintenance(const calc::Project& project, calc::Diagnostics& diagnostics);

// In order.
std::vector<Requirement> requirements_of_plane(const std::vector<Requirement>& requirements,
                                               std::string_view plane_id);

}  // namespace rules
