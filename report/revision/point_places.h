#pragma once
// Points of a plane beside those of an earlier one: by place, so that a rectangle that begins at
// another corner, or a list in another order, has the same points.

#include "report/document/document.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace report {

// A point of a plane's grid, measured or left out.
struct PlacedPoint {
  glm::dvec3 position_m{0.0};
  int column = 0, row = 0;
  const PointRow* measured = nullptr;  // null: left out
};

struct PointPairs {
  std::vector<std::pair<PlacedPoint, PlacedPoint>> both;  // before, after
  std::vector<PlacedPoint> gone, added;                   // at a place that the other has not
};

// Each point belongs to one pair at most.
PointPairs match_points(const PlanePart& before, const PlanePart& after);

// Of two planes with cells along the same sides: whether each point of the one that is measured has
// one of the other that is measured within its cell; of routes, as near as the cell is large.
bool has_points_in_all_cells(const PlanePart& of, const PlanePart& in);

// Of cells that both have: how far the point of one has moved at most; 0 without such cells.
double farthest_move_m(const PointPairs& pairs);

}  // namespace report
