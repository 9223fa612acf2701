#pragma once
// Walls and ceiling of a room with several workplaces, and requirements on the room itself: each
// gets one plane, however many workplaces need it.

#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace rules {

// Returns the index of the space's plane with the same points as `made`, which a workplace of this
// pack would make of a wall or the ceiling. Empty: there is none, or `made` is neither.
std::optional<std::size_t> same_surface(const calc::CalcPlane& made, const RulePack& pack,
                                        const calc::Space& space);

// Adds the requirements of `made` to `plane`; equal ones are merged with their workplaces' ids.
void ask_also(calc::CalcPlane& plane, const calc::CalcPlane& made);

// Adds a requirement on the space itself to this plane of the space, unless a plane of another
// workplace already has the same. Does nothing if there is no such plane.
void ask_of_space(const calc::RequirementText& text, calc::Space& space, std::size_t plane);

// Names the planes that several workplaces use, and their origins. To be called at the end.
void name_shared_planes(calc::Space& space);

}  // namespace rules
