#pragma once
// The light of each luminaire on a plane.

#include "calc/base/field.h"
#include "calc/scene/project.h"
#include "report/document/document.h"

namespace report {

// Returns the shares. field: of a scene after separate_luminaires(), whose channels are
// `luminaires` in order. plane: with its points, in the field's order. level: of the intervals, as
// the plane's own. Empty for ratings and ratios, which are no sums over luminaires.
LuminaireShares build_luminaire_shares(const calc::PlaneField& field,
                                       const std::vector<calc::Luminaire>& luminaires,
                                       const std::vector<calc::LuminaireType>& types,
                                       const PlanePart& plane, double level);

}  // namespace report
