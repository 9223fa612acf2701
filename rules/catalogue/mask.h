#pragma once
// Which points of a plane a statistic counts. It belongs to the statistic, not to the plane: one
// plane may have several.

#include "calc/base/message.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <string>
#include <vector>

namespace rules {

enum class MaskStep {
  inset,        // without a strip along the whole outline
  walls,        // without what is near to a wall of the room
  border,       // walls; in the open, and where no walls are known, inset
  across,       // without a strip along the two sides that run the way people go
  centre_line,  // the points next to the line midway between those sides
};

struct MaskOperation {
  MaskStep step = MaskStep::inset;
  // Width of the strip, for inset and across: metres; or, for planes at most up_to_width_m wide,
  // this share of their width. For walls and border: metres.
  double metres = 0.0;
  double share = 0.0;  // [0, 0.5)
  // Also of centre_line: wider planes are not judged by it; 0 there: all are.
  double up_to_width_m = 0.0;
};

// Points must be in the result of every operation; without any, all count.
struct Mask {
  std::string id;  // "" = all points
  std::vector<MaskOperation> operations;
};

struct MaskedPoints {
  std::vector<std::size_t> points;  // ascending
  calc::Message problem;            // why it cannot be said which points count; "" = none
};

// Distances are from the plane's outline (its holes have none), so that a margin of the grid has no
// influence. Width is across grid.travel, or the shorter side where that is not said; across and
// centre_line are refused there if the sides are too alike to tell. Distances from walls are
// horizontal, from the room's footprint, and for lists of points, too. In the open space there are
// no walls. An inset works for every outline, but for shares of a width, across and centre_line the
// plane must be a rectangle or a route. Of a route the width and the way are its own: its strips
// run along the line, its centre line is the middle row, and an inset takes both ends, too.
MaskedPoints apply_mask(const Mask& mask, const calc::SensorGrid& grid);

// With walls or inset in place of border.
Mask mask_at(Mask mask, bool has_no_walls);

// "without a strip along the outline of 0.5 m": all operations; "" without any. travel: of the
// plane, which says what is across; 0: it is not said, or asked.
calc::Message mask_words(const Mask& mask, const glm::dvec3& travel = glm::dvec3(0.0));

}  // namespace rules
