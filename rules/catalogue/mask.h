#pragma once
// The points of a plane that a statistic counts. A mask belongs to the statistic, not to the plane:
// one plane may have several.

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
  // Applies to centre_line, too: wider planes are not judged by it; 0: planes of any width are.
  double up_to_width_m = 0.0;
};

// Points must be in the result of every operation; without operations, all count.
struct Mask {
  std::string id;  // "" = all points
  std::vector<MaskOperation> operations;
};

struct MaskedPoints {
  std::vector<std::size_t> points;  // ascending
  calc::Message problem;            // why it cannot be said which points count; "" = none
};

// Returns the points that count. Distances are from the plane's outline (its holes have none), so a
// margin of the grid has no influence. Width is across grid.travel, or the shorter side if that is
// not given; across and centre_line are refused if the sides are then too alike. Distances from
// walls are horizontal, from the room's footprint, also for point lists; the open space has no
// walls. An inset works for every outline; shares of a width, across and centre_line need a
// rectangle or a route. A route has its own width and direction: its strips run along the line, its
// centre line is the middle row, and an inset cuts both ends, too.
MaskedPoints apply_mask(const Mask& mask, const calc::SensorGrid& grid);

// Returns the mask with walls or inset in place of border.
Mask mask_at(Mask mask, bool has_no_walls);

// Returns all operations, "without a strip along the outline of 0.5 m"; "" without any. travel: of
// the plane, which defines across; 0: not given or not needed.
calc::Message mask_words(const Mask& mask, const glm::dvec3& travel = glm::dvec3(0.0));

}  // namespace rules
