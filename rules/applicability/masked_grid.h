#pragma once
// Whether the points that count are as many and as close as a rule wants them.

#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/mask.h"
#include "rules/pack/rule_pack.h"

#include <optional>

namespace rules {

// Cells that a pack's grid gives to an area with these sides, metres. It must have a rule.
calc::GridCounts asked_counts(const RuleGrid& grid, double u_m, double v_m);

// The points of a grid that a mask leaves, where it takes some: whole cells, by their centres.
struct CellsLeft {
  int columns, rows;  // from the first to the last
  double u_m, v_m;    // their sides
};
// Empty: the mask takes none, or it cannot be said which; or the grid is a route's.
std::optional<CellsLeft> cells_left(const Mask& mask, const calc::SensorGrid& grid);

// A place that counts, with no point for it: cells whose centres a mask takes may reach out of what
// it takes. Along the side on which the place is farther off than a point may be.
struct MaskGap {
  double to_point_m;  // from the nearest point that counts, or would if nothing stood there
  double most_m;      // that is allowed, by the spacing that is asked for
};
// The widest one, looked for at some places in each cell that the mask takes; none where these are
// very many.
std::optional<MaskGap> mask_gap(const Mask& mask, const calc::SensorGrid& grid,
                                const RuleGrid& asked);

}  // namespace rules
