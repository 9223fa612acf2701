#pragma once
// Joins walls of a room that a drawing has cut into pieces.

#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// Joins walls that continue straight into one wall of workplace.walls, with the number of the
// first; walls named by a <zone> or <without> stay separate. Returns for every wall the wall that
// it has become a part of.
std::vector<std::optional<std::size_t>> join_straight_walls(const RulePack& pack,
                                                            calc::Workplace& workplace);

// Returns "walls 2 to 9, pieces of a wall of 8.00 m, ..."; "" if there are none. It names walls
// that are too narrow to be judged singly but continue nearly straight and together are as wide as
// others, such as an arc or a slightly bent side. part_of: the result of join_straight_walls().
std::string run_of_pieces(const std::vector<calc::PlanarArea>& walls,
                          const std::vector<std::optional<std::size_t>>& part_of,
                          const std::vector<std::size_t>& too_narrow);

}  // namespace rules
