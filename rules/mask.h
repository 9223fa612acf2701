#pragma once
// Which points of a plane a statistic counts. It belongs to the statistic, not to the plane: one
// plane may have several.

#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <string>
#include <vector>

namespace rules {

enum class MaskStep {
  inset,        // without a strip along all four sides
  across,       // without a strip along the two long sides
  centre_line,  // the points next to the line midway between the long sides
};

struct MaskOperation {
  MaskStep step = MaskStep::inset;
  // Width of the strip, for inset and across: metres; or, for planes whose shorter side is at most
  // up_to_width_m, this share of that side.
  double metres = 0.0;
  double share = 0.0;  // [0, 0.5)
  double up_to_width_m = 0.0;
};

// Points must be in the result of every operation; without any, all count.
struct Mask {
  std::string id;  // "" = all points
  std::vector<MaskOperation> operations;
};

struct MaskedPoints {
  std::vector<std::size_t> points;  // ascending
  std::string problem;              // why it cannot be said which points count; "" = none
};

// Distances are from the plane's outline, so that a margin of the grid has no influence. Only for
// planes that are rectangles: a list of points has no sides, and a polygon no two long ones.
MaskedPoints apply_mask(const Mask& mask, const calc::SensorGrid& grid);

}  // namespace rules
