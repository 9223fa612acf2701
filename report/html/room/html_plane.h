#pragma once
// The card of a plane: requirements, heat map, statistics, sampling, values.

#include "report/document/document.h"
#include "report/html/drawings/shared_scale.h"
#include "report/html/page/html_footnotes.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/print_pages.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Returns a card that can be folded. folds_passed: it starts folded if all its requirements are met
// or waived. groups: level_groups() of the room.
std::string html_plane(const Texts& t, PlaneIndex index, const SpacePart& space,
                       const PlanePart& plane, const ColourScales& scales, bool folds_passed,
                       const std::vector<std::string>& groups, Paper paper,
                       const Footnotes& footnotes);

// A report of at most this many planes can show them all.
inline constexpr std::size_t kFewPlanes = 3;

}  // namespace report
