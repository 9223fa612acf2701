#pragma once
// Lines of equal value between the cell centres of a plane; for illuminances they are isolux lines.

#include "report/document/document.h"
#include "report/html/drawings/plan_layout.h"
#include "report/images/heatmap.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace report {

// A line in metres from grid.origin_m along u and v; a closed one ends where it starts.
struct IsoluxLine {
  std::vector<glm::dvec2> points_m;
  bool is_closed = false;
};

// Returns lines where the plane's values cross level: marching squares over neighbouring cell
// centres, values linear between two of them, so a linear field is met exactly and any other within
// h^2 / 8 * max|E''| / |E'|, h = the distance of two centres. Where four centres form a saddle,
// their mean decides which sides belong together. From the outermost centres of a grid the lines go
// straight to its edge, as the cells' colours do; none is drawn beside a cell without a point, or
// beyond the outermost centres of a route. Needs has_cells(plane).
std::vector<IsoluxLine> isolux_lines(const PlanePart& plane, double level);

struct IsoluxLevel {
  double value = 0.0;                  // in the plane's unit
  bool is_required = false;            // a limit of the drawing: drawn thicker
  std::vector<IsoluxLine> lines = {};  // filled by trace_isolux()
};

// Returns the borders of the scale's bands between the plane's lowest and highest value, only
// multiples of two or five steps if there are more than `most`, and its limits in the same range;
// ascending. scale: of bands of equal width.
std::vector<IsoluxLevel> isolux_levels(const PlanePart& plane, const ColourScale& scale,
                                       const std::vector<PlanLimit>& limits, int most);

// Fills the lines of levels, required levels first, while all together have at most most_points; a
// level that would exceed that is removed. Returns false if any was: browsers cannot show the lines
// of a noisy field of a million cells.
bool trace_isolux(const PlanePart& plane, std::size_t most_points,
                  std::vector<IsoluxLevel>& levels);

}  // namespace report
