#pragma once
// Builds a street for reports: the project's data, and the values for its drivers.

#include "calc/scene/project.h"
#include "report/document/document.h"

#include <optional>
#include <vector>

namespace report {

// Returns the street; empty: the space is no road. planes: of the space, judged; the light is that
// of the first requirement on luminance or glare of drivers, else full output.
std::optional<RoadPart> build_road(const calc::Project& project, const calc::Space& space,
                                   const std::vector<PlanePart>& planes);

}  // namespace report
