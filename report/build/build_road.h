#pragma once
// A street for reports: what the project says of it, and what its drivers see.

#include "calc/scene/project.h"
#include "report/document/document.h"

#include <optional>
#include <vector>

namespace report {

// Nothing: the space is no road. planes: of the space, judged; the light is that which the first
// requirement on luminance or glare of drivers asks for, else full output.
std::optional<RoadPart> build_road(const calc::Project& project, const calc::Space& space,
                                   const std::vector<PlanePart>& planes);

}  // namespace report
