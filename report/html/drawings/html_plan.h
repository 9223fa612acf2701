#pragma once
// The drawing of a plane: heat map, outlines, luminaires, and the legend.

#include "report/document/document.h"
#include "report/html/drawings/isolux.h"
#include "report/html/drawings/shared_scale.h"
#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Most cells drawn singly; more are embedded as one picture.
inline constexpr std::size_t kMostSvgCells = 2500;

// The space that a plan has on paper.
struct PlanPlace {
  glm::dvec2 most_mm{72, 43};
  // A long plane may be cut across into at most this many pieces, below or beside each other, so
  // that its values can be read.
  int most_pieces = 1;
};
// Returns the space beside the tables of a plane, as in html_style.css.
PlanPlace place_beside_tables(Paper paper);

// Returns a <figure> with inline SVG pictures: plan, legend, and the legend for paper. Printed
// values and words have at least 6.5 points: if values do not fit, every second, third ... of a row
// or column is printed, and the caption says so. anchor: unique in the page, used for ids. Needs
// has_cells(plane).
std::string html_plan(const Texts& t, const SpacePart& space, const PlanePart& plane,
                      const PlaneScale& scale, std::string_view anchor, const PlanPlace& place);

// Isolux lines for other drawings of the same plane. Needs has_cells(plane) and
// has_all_values(plane).
struct PlanIsolux {
  std::vector<IsoluxLevel> levels;
  bool has_all = true;  // none was left out for too many corners
};
PlanIsolux plan_isolux(const Texts& t, const SpacePart& space, const PlanePart& plane,
                       const PlaneScale& scale);

// The same two pictures for their own file, one below the other, with their sizes.
struct PlanPictures {
  std::string plan, colour_bar;  // <svg> elements without name space or style
  double width_px = 0.0, plan_height_px = 0.0, bar_height_px = 0.0;
};
PlanPictures plan_pictures(const Texts& t, const SpacePart& space, const PlanePart& plane,
                           const PlaneScale& scale);

}  // namespace report
