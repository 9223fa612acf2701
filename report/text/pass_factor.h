#pragma once
// The factor on a plane's light with which a requirement would be met.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <optional>
#include <string>

namespace report {

// Returns the factor on all light of the plane at which the quantity meets its limit exactly, with
// an interval from the measurement's. Only for quantities linear in illuminance: averages, minima,
// maxima, percentiles and values of points. Empty for ratios, ratings and shares; if the limit or
// the lower end of the measurement is not above 0; for every verdict but fail (an undecided
// requirement may need no other light); for failures that more light would not mend; for strict
// limits, which are not met when reached; and for an own decision policy, whose true limit differs.
std::optional<calc::Estimate> pass_factor(const rules::Finding& finding);

// Returns the factor on one group's light with which the plane's maintained average is proved to
// meet this requirement. Empty unless it is a failing lower limit on the maintained average of all
// points, without a light scene, and the group is known to give light. Uses the lower ends of both
// intervals: 1 + (limit - average) / average of the group.
std::optional<double> group_pass_factor(const rules::Finding& finding, const PlanePart& plane,
                                        const GroupShare& share);

// Returns "Reaches the limit with all light at ×1.11.", for an upper limit "Comes down to the limit
// with all light at ×0.91."; "" without a factor. It is the end of the factor's interval at which
// the whole measured interval is on the good side, rounded to that side.
std::string pass_factor_words(const Texts& t, const rules::Finding& finding);

// Returns the words for a remedy. If uniformity or glare of the space also fails in that scene,
// more light alone does not make the room pass, and the words say so instead.
std::string remedy_words(const Texts& t, const SpacePart& space, const rules::Finding& finding);

// Returns "×1.09", rounded up.
std::string factor_text(const Texts& t, double factor);

}  // namespace report
