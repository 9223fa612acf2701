#pragma once
// Compares the illuminances of a plane with earlier ones.

#include "report/document/document.h"
#include "report/document/revision.h"

#include <optional>

namespace report {

// Returns the changes. Empty if values are equal, or points cannot be compared: another grid,
// ratings and ratios, a plane that was not computed. place: of the plane.
std::optional<ChangedPlane> compare_values(const PlanePart& before, const PlanePart& after,
                                           const RevisionPlace& place);

}  // namespace report
