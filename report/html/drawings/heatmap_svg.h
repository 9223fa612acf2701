#pragma once
// The drawing of a plane as an SVG file of its own: what the HTML page shows, in colours for paper.

#include "report/document/document.h"
#include "report/html/drawings/shared_scale.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Plan, lines of equal value, luminaires and furniture, with the colour bar, its limits and whom it
// is shared among below.
// Needs has_cells(plane) and has_all_values(plane).
std::string render_heatmap_svg(const Texts& t, const SpacePart& space, const PlanePart& plane,
                               const PlaneScale& scale);

// "Office – Task", for pictures outside of a page; no markup.
std::string plane_picture_title(const Texts& t, const SpacePart& space, const PlanePart& plane);

}  // namespace report
