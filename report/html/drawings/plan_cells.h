#pragma once
// The cells of a plane's points at their places in its drawing.

#include "report/html/drawings/plan_layout.h"
#include "report/images/heatmap.h"

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace report {

// The cells of a plane with has_cells(), which must outlive them.
struct PlanCells {
  const PlanePart& plane;
  PlanLayout layout;
  std::optional<calc::RouteCells> route = {};  // whose cells lie along a line

  // Returns the size of a cell; for a route a square that fits into its cells, some of which are
  // smaller at bends.
  glm::dvec2 cell_px() const;
  glm::dvec2 cell_middle_px(int column, int row) const;
  std::string cell_path(int column, int row) const;
  // Returns the upper left corner of a cell in the picture.
  glm::dvec2 cell_corner_px(int column, int row) const;
};
PlanCells plan_cells(const SpacePart& space, const PlanePart& plane, const glm::dvec2& wanted_px);

// Returns the points by colour band, in drawing order: one group for each keeps the file small.
std::map<int, std::vector<const PointRow*>> points_by_band(const PlanePart& plane,
                                                           const ColourScale& scale);

// Returns a rectangle for the attribute d of a path.
std::string svg_rectangle(const glm::dvec2& corner, const glm::dvec2& size);

}  // namespace report
