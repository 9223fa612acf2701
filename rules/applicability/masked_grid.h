#pragma once
// Checks whether the counted points are as many and as close as a rule requires.

#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/mask.h"
#include "rules/pack/rule_pack.h"

#include <optional>

namespace rules {

// Returns the cells that a pack's grid gives to an area with these sides, in metres. The grid must
// have a rule.
calc::GridCounts asked_counts(const RuleGrid& grid, double u_m, double v_m);

// The points of a grid left by a mask that removes some: whole cells, by their centres.
struct CellsLeft {
  int columns, rows;  // from the first to the last
  double u_m, v_m;    // their sides
};
// Returns the cells left; empty if the mask removes none, if that cannot be said, or for a route.
std::optional<CellsLeft> cells_left(const Mask& mask, const calc::SensorGrid& grid);

// A counted place without a point: cells whose centres a mask removes may reach beyond the masked
// part. Measured along the side on which the place is farther from a point than allowed.
struct MaskGap {
  double to_point_m;  // from the nearest point that counts, or would if nothing stood there
  double most_m;      // that is allowed, by the spacing that is asked for
};
// Returns the widest gap, sampled at some places in each cell that the mask removes; none if there
// are very many.
std::optional<MaskGap> mask_gap(const Mask& mask, const calc::SensorGrid& grid,
                                const RuleGrid& asked);

}  // namespace rules
