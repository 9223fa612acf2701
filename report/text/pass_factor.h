#pragma once
// By how much the light of a plane must change for a requirement to be met.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <optional>
#include <string>

namespace report {

// The factor on all light of the plane at which the quantity meets its limit exactly, with the
// interval that follows from the measurement's. Illuminances are linear in it: averages, minima,
// maxima, percentiles and values of points; empty for ratios, ratings and shares, where the limit
// or the lower end of the measurement is not above 0, for every verdict but fail (of what is
// undecided nobody knows whether it needs another light at all), for what fails for a reason that
// more light of all would not mend, for strict limits, which are not met where they are reached,
// and for a decision policy of its own, whose true limit is another.
std::optional<calc::Estimate> pass_factor(const rules::Finding& finding);

// The factor on one group's light alone at which the plane's maintained average is proved to meet
// this requirement; empty unless it asks for at least some maintained average of all points, in no
// light scene, which fails, and the group is known to give light. With the lower ends of both
// intervals: 1 + (limit - average) / average of the group.
std::optional<double> group_pass_factor(const rules::Finding& finding, const PlanePart& plane,
                                        const GroupShare& share);

// "Reaches the limit with all light at ×1.11.", of an upper limit "Comes down to the limit with all
// light at ×0.91."; "" without a factor. It is the end of the interval that proves it: with that
// factor the whole interval of the measurement is on the good side. Rounded to that side.
std::string pass_factor_words(const Texts& t, const rules::Finding& finding);

// The same where it is a remedy. Where uniformity or glare of the space fails in that scene, too,
// more light alone does not make the room pass, and these words say so instead.
std::string remedy_words(const Texts& t, const SpacePart& space, const rules::Finding& finding);

// "×1.09", rounded up.
std::string factor_text(const Texts& t, double factor);

}  // namespace report
