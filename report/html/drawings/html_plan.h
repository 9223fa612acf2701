#pragma once
// The drawing of one plane: heat map, outlines, luminaires, and the legend that explains it.

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

// Points whose cells are drawn one by one; more go in as one embedded picture.
inline constexpr std::size_t kMostSvgCells = 2500;

// The room that a plan has on paper.
struct PlanPlace {
  glm::dvec2 most_mm{72, 43};
  // A long plane may be cut across into so many pieces, which stand below or beside each other, so
  // that its values can be read.
  int most_pieces = 1;
};
// Beside the tables of a plane, as html_style.css has it.
PlanPlace place_beside_tables(Paper paper);

// A <figure> with inline SVG pictures: plan, legend, and the legend as paper has it. Printed values
// and words have at least 6.5 points: where values have no room there, every second, third ... of a
// row or column is printed, and the caption says so. anchor: unique in the page, used for ids.
// Needs has_cells(plane).
std::string html_plan(const Texts& t, const SpacePart& space, const PlanePart& plane,
                      const PlaneScale& scale, std::string_view anchor, const PlanPlace& place);

// Its isolux lines alone, for other drawings of the same plane. Needs has_cells(plane) and
// has_all_values(plane).
struct PlanIsolux {
  std::vector<IsoluxLevel> levels;
  bool has_all = true;  // none was left out for too many corners
};
PlanIsolux plan_isolux(const Texts& t, const SpacePart& space, const PlanePart& plane,
                       const PlaneScale& scale);

// The same two pictures for a file of their own, one below the other, and how large they are.
struct PlanPictures {
  std::string plan, colour_bar;  // <svg> elements without name space or style
  double width_px = 0.0, plan_height_px = 0.0, bar_height_px = 0.0;
};
PlanPictures plan_pictures(const Texts& t, const SpacePart& space, const PlanePart& plane,
                           const PlaneScale& scale);

}  // namespace report
