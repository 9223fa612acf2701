#pragma once
// The card of one plane: requirements, heat map, statistics, how it was measured, values.

#include "report/document.h"
#include "report/html_markup.h"

#include <string>

namespace report {

std::string html_plane(PlaneIndex index, const SpacePart& space, const PlanePart& plane);

}  // namespace report
