#pragma once
// Matches points of a plane with those of an earlier plane by place, so that a rectangle that
// begins at another corner, or a list in another order, has the same points.

#include "report/document/document.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace report {

// A point of a plane's grid, measured or omitted.
struct PlacedPoint {
  glm::dvec3 position_m{0.0};
  int column = 0, row = 0;
  const PointRow* measured = nullptr;  // null: left out
};

struct PointPairs {
  std::vector<std::pair<PlacedPoint, PlacedPoint>> both;  // before, after
  std::vector<PlacedPoint> gone, added;                   // at a place that the other has not
};

// Matches points; each belongs to one pair at most.
PointPairs match_points(const PlanePart& before, const PlanePart& after);

// Returns, for two planes with cells along the same sides, whether each measured point of `of` has
// a measured point of `in` within its cell; for routes, within the size of a cell.
bool has_points_in_all_cells(const PlanePart& of, const PlanePart& in);

// Returns the farthest move of a point in cells that both have; 0 without such cells.
double farthest_move_m(const PointPairs& pairs);

}  // namespace report
