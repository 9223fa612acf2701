#pragma once
// Light levels that a reader may move on the page: it previews the values of planes and never shows
// a verdict. The page's script (html_levels.js) does it; without a script they are hidden.

#include "report/document/document.h"
#include "report/html/drawings/shared_scale.h"
#include "report/text/number_format.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

// Returns the dimming groups of all planes of a room that react to levels, in order of first use:
// those of its panel.
std::vector<std::string> level_groups(const SpacePart& space);

// Returns a slider for each of these groups and for the maintenance factor, and the project's light
// scenes. Hidden, until the script shows it; "" without groups: no plane of the room reacts.
std::string html_levels(const Texts& t, const ProjectPart& project,
                        const std::vector<std::string>& groups);

// Returns a plane's data for the script, as attributes of the element that holds its results:
//   data-light    "GROUP:AVERAGE:VALUE VALUE ...;GROUP:...": lx at full output, maintained, by the
//                 number of a group in the room's panel, point by point in drawing order
//   data-cells    the same points' places in the table of values; absent for lists
//   data-limits   "at_least 500;...": for single points, at full output; data-limit-words: to read
//   data-scale    "LOW STEP", with data-colours and data-inks: by band; absent for lists
// "" if the plane does not react: ratings and ratios, and too many points.
std::string level_attributes(const Texts& t, const SpacePart& space, const PlanePart& plane,
                             const ColourScales& scales, const std::vector<std::string>& groups);

// Returns " data-limits=\"at_least 500;at_most 800\""; "" without any.
std::string limits_attribute(const Thresholds& thresholds);

}  // namespace report
