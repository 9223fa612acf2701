#pragma once
// Illuminances of a plane beside those that it had.

#include "report/document/document.h"
#include "report/document/revision.h"

#include <optional>

namespace report {

// Empty where both have the same values, or no points that could be compared one by one: another
// grid, ratings and ratios, a plane that was not computed. place: of the plane.
std::optional<ChangedPlane> compare_values(const PlanePart& before, const PlanePart& after,
                                           const RevisionPlace& place);

}  // namespace report
