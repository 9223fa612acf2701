#pragma once
// By how much the light of a plane must change for a requirement to be met.

#include "report/document.h"

#include <optional>
#include <string>

namespace report {

// The factor on all light of the plane at which the quantity meets its limit exactly, with the
// interval that follows from the measurement's. Illuminances are linear in it: averages, minima,
// maxima, percentiles and values of points; empty for ratios and shares, where the limit or the
// lower end of the measurement is not above 0, for a requirement that is met or was not judged, and
// for one with a decision policy of its own, whose true limit is another.
std::optional<calc::Estimate> pass_factor(const rules::Finding& finding);

// The factor on one group's light alone at which the plane's maintained average meets this
// requirement; empty unless it asks for at least some maintained average of all points, in no light
// scene, which is not met, and the group gives light. 1 + (limit - average) / average of the group.
std::optional<double> group_pass_factor(const rules::Finding& finding, const PlanePart& plane,
                                        const GroupShare& share);

// "Would be met with all light at ×1.09 (1.08 to 1.11)."; "" without a factor. Ends are rounded
// outwards, and the factor to the side on which the requirement is met.
std::string pass_factor_words(const rules::Finding& finding);

// "×1.09", rounded up.
std::string factor_text(double factor);

}  // namespace report
