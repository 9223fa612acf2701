#pragma once
// The drawing of a plane as its own SVG file: the drawing of the HTML page, in colours for paper.

#include "report/document/document.h"
#include "report/html/drawings/shared_scale.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns plan, lines of equal value, luminaires and furniture, with the colour bar below, its
// limits and the sharing of the scale. Needs has_cells(plane) and has_all_values(plane).
std::string render_heatmap_svg(const Texts& t, const SpacePart& space, const PlanePart& plane,
                               const PlaneScale& scale);

// Returns "Office – Task", for pictures outside of a page; no markup.
std::string plane_picture_title(const Texts& t, const SpacePart& space, const PlanePart& plane);

}  // namespace report
