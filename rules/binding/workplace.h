#pragma once
// <workplace> of a project: the planes that the row of a rule pack asks for.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <vector>

namespace rules {

// Adds to every space the planes of its workplaces, which require what the row says for their role,
// and notes about roles of which no plane is made. Plane ids are "<workplace>.<role>", walls
// "<workplace>.wall.2". To be called once, before bind_requirements(). Errors (an unknown
// attribute, pack or row, a zone of which nothing is left, an id that is taken) are reported at the
// project's lines; their workplace has no planes then, nor has one with an error of its own.
// is_good: false of a project with other errors, whose luminaires may have no type; nothing is then
// taken from them.
void make_workplace_planes(calc::Project& project, const std::vector<RulePack>& packs,
                           calc::Diagnostics& diagnostics, bool is_good = true);

}  // namespace rules
