#pragma once
// The cells of a plane's points, where they lie in its drawing.

#include "report/html/plan_layout.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace report {

// Of a plane with has_cells(); must not outlive it.
struct PlanCells {
  const PlanePart& plane;
  PlanLayout layout;
  std::optional<calc::RouteCells> route = {};  // whose cells lie along a line

  // Of a route a square that fits into its cells; some at bends are smaller.
  glm::dvec2 cell_px() const;
  glm::dvec2 cell_middle_px(int column, int row) const;
  std::string cell_path(int column, int row) const;
  // Upper left corner of a cell in the picture.
  glm::dvec2 cell_corner_px(int column, int row) const;
};
PlanCells plan_cells(const SpacePart& space, const PlanePart& plane, const glm::dvec2& wanted_px);

// For the attribute d of a path.
std::string svg_rectangle(const glm::dvec2& corner, const glm::dvec2& size);

}  // namespace report
