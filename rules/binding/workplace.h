#pragma once
// <workplace> of a project: the planes that the row of a rule pack requires.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <vector>

namespace rules {

// Adds to every space the planes of its workplaces, with the row's requirements for their role, and
// notes about roles without a plane. Plane ids are "<workplace>.<role>", of walls
// "<workplace>.wall.2". Call it once, before bind_requirements(). Errors (an unknown attribute,
// pack or row, an empty zone, an id in use) are reported at the project's lines; a workplace with
// any error gets no planes. is_good: false for a project with other errors, whose luminaires may
// have no type and are then not used.
void make_workplace_planes(calc::Project& project, const std::vector<RulePack>& packs,
                           calc::Diagnostics& diagnostics, bool is_good = true);

}  // namespace rules
