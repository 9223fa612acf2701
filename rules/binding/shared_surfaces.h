#pragma once
// Walls and ceiling of a room with several workplaces, and the room itself: one plane each, whoever
// asks something of it.

#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace rules {

// The plane of the space, an index, that has the very points of one that a workplace of this pack
// would make of a wall or the ceiling; empty: none has, or it is not about those.
std::optional<std::size_t> same_surface(const calc::CalcPlane& made, const RulePack& pack,
                                        const calc::Space& space);

// Has `plane` asked for what `made` would be: beside what it is asked for, unless that is the same.
void ask_also(calc::CalcPlane& plane, const calc::CalcPlane& made);

// What is asked of the space itself is asked once: of this plane of the space, unless a plane of
// another workplace is asked the same. Nothing if there is no such plane.
void ask_of_space(const calc::RequirementText& text, calc::Space& space, std::size_t plane);

// At the end: names and origins of planes that several workplaces ask something of.
void name_shared_planes(calc::Space& space);

}  // namespace rules
