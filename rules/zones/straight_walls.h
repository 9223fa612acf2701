#pragma once
// Walls of a room that a drawing has cut into pieces.

#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// Walls that go on straight become one wall of workplace.walls, by the number of the first of them;
// those that a <zone> or <without> names stay by themselves. Returns, of every wall, the one that
// it has become a part of.
std::vector<std::optional<std::size_t>> join_straight_walls(const RulePack& pack,
                                                            calc::Workplace& workplace);

// Of walls that are too narrow to be judged one by one: those that go on nearly straight and
// together are a wall as wide as others, such as an arc or a side that a drawing has bent by a
// hair. part_of: as join_straight_walls() gives it. "walls 2 to 9, pieces of a wall of 8.00 m,
// ..."; "" if there are none.
std::string run_of_pieces(const std::vector<calc::PlanarArea>& walls,
                          const std::vector<std::optional<std::size_t>>& part_of,
                          const std::vector<std::size_t>& too_narrow);

}  // namespace rules
