#pragma once
// Lines of equal value, of illuminances isolux lines, between the cell centres of a plane.

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

// Lines where the plane's values cross level: marching squares over neighbouring cell centres,
// values linear between two of them, so that a linear field is met exactly and any other one within
// h^2 / 8 * max|E''| / |E'|, h = the distance of two centres. Where four centres form a saddle, the
// mean of the four says which sides belong together. From the outermost centres of a grid they go
// on straight to its edge, as the cells' colours do; nothing is drawn beside a cell without a
// point, and nothing beyond the outermost centres of a route. Needs has_cells(plane).
std::vector<IsoluxLine> isolux_lines(const PlanePart& plane, double level);

struct IsoluxLevel {
  double value = 0.0;                  // in the plane's unit
  bool is_required = false;            // a limit of the drawing: drawn thicker
  std::vector<IsoluxLine> lines = {};  // filled by trace_isolux()
};

// Every border of the scale's bands, or only the multiples of two or five steps where there are
// more than `most`, that lies between the plane's lowest and highest value, and its limits in the
// same range; ascending. scale: of bands of equal width.
std::vector<IsoluxLevel> isolux_levels(const PlanePart& plane, const ColourScale& scale,
                                       const std::vector<PlanLimit>& limits, int most);

// Fills the lines of levels, required ones first, as long as all of them together have at most
// most_points; a level that would have more is taken out. False if any was: a noisy field of a
// million cells would make a picture that no browser shows.
bool trace_isolux(const PlanePart& plane, std::size_t most_points,
                  std::vector<IsoluxLevel>& levels);

}  // namespace report
