#include "report/html/drawings/plan_cells.h"

#include "report/html/drawings/html_isolux.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace report {

std::string svg_rectangle(const glm::dvec2& corner, const glm::dvec2& size) {
  return fmt::format("M{} {}h{}v{}h-{}z", svg_number(corner.x), svg_number(corner.y),
                     svg_number(size.x), svg_number(size.y), svg_number(size.x));
}

glm::dvec2 PlanCells::cell_px() const {
  const glm::dvec2 size_m(plane.grid.spacing_u_m, plane.grid.spacing_v_m);
  return (route ? glm::dvec2(std::min(size_m.x, size_m.y)) : size_m) * layout.pixels_per_metre;
}

glm::dvec2 PlanCells::cell_middle_px(int column, int row) const {
  if (!route) return cell_corner_px(column, row) + 0.5 * cell_px();
  return layout.pixel(glm::dvec2(route->centre_m(column, row) - plane.grid.origin_m));
}

std::string PlanCells::cell_path(int column, int row) const {
  if (!route) return svg_rectangle(cell_corner_px(column, row), cell_px());
  std::vector<glm::dvec2> corners_m = route->corners_m(column, row);
  for (glm::dvec2& corner : corners_m) corner -= glm::dvec2(plane.grid.origin_m);
  return svg_path(layout, corners_m);
}

glm::dvec2 PlanCells::cell_corner_px(int column, int row) const {
  return layout.pixel({column * plane.grid.spacing_u_m, (row + 1) * plane.grid.spacing_v_m});
}

std::map<int, std::vector<const PointRow*>> points_by_band(const PlanePart& plane,
                                                           const ColourScale& scale) {
  std::map<int, std::vector<const PointRow*>> bands;
  for (const PointRow& point : plane.points)
    bands[band_of(scale, point.measured.value)].push_back(&point);
  return bands;
}

PlanCells plan_cells(const SpacePart& space, const PlanePart& plane, const glm::dvec2& wanted_px) {
  PlanCells cells{plane, lay_out_plan(space, plane, wanted_px)};
  if (plane.grid.route) cells.route.emplace(plane.grid.route->cells(plane.grid.rows));
  return cells;
}

}  // namespace report
