#pragma once
// Walls of a room that a drawing has cut into pieces.

#include "calc/scene/project.h"
#include "rules/rule_pack.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace rules {

// Walls that go on straight become one wall of workplace.walls, by the number of the first of them;
// those that a <zone> or <without> names stay by themselves. Returns, of every wall, the one that
// it has become a part of.
std::vector<std::optional<std::size_t>> join_straight_walls(const RulePack& pack,
                                                            calc::Workplace& workplace);

}  // namespace rules
