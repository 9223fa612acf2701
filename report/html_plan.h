#pragma once
// The drawing of one plane: heat map, outlines, luminaires, and the legend that explains it.

#include "report/document.h"
#include "report/texts.h"

#include <string>
#include <string_view>

namespace report {

// A <figure> with two inline SVG pictures (plan and legend). anchor: unique in the page, used for
// ids. Needs has_cells(plane).
std::string html_plan(const Texts& t, const SpacePart& space, const PlanePart& plane,
                      std::string_view anchor);

}  // namespace report
