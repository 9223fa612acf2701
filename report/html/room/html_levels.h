#pragma once
// Levels of light that a reader may move on the page: what planes would then have, as a preview
// and never as a verdict. The page's script (html_levels.js) does it; without one nothing is seen
// of it.

#include "report/document/document.h"
#include "report/html/drawings/shared_scale.h"
#include "report/text/number_format.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// The dimming groups of all planes of a room that follow, in order of first use: those of its
// panel.
std::vector<std::string> level_groups(const SpacePart& space);

// A slider for each of these groups, one for the maintenance factor, and the project's light
// scenes. Hidden, until the script shows it; "" without groups: no plane of the room follows.
std::string html_levels(const Texts& t, const ProjectPart& project,
                        const std::vector<std::string>& groups);

// What the script needs of a plane, as attributes of the element that holds its results:
//   data-light    "GROUP:AVERAGE:VALUE VALUE ...;GROUP:...": lx at full output, maintained, by
//   number
//                 of a group in the room's panel, point by point as they are drawn
//   data-cells    the same points' places in the table of values; absent of lists
//   data-limits   "at_least 500;...": of single points, at full output; data-limit-words: to read
//   data-scale    "LOW STEP", with data-colours and data-inks: by band; absent of lists
// "" where the plane does not follow: ratings and ratios, and too many points.
std::string level_attributes(const Texts& t, const SpacePart& space, const PlanePart& plane,
                             const ColourScales& scales, const std::vector<std::string>& groups);

// " data-limits=\"at_least 500;at_most 800\""; "" without any.
std::string limits_attribute(const Thresholds& thresholds);

}  // namespace report
