#pragma once
// What should be told of waivers in time: that they end soon, that nobody needs them any more.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/catalogue/aggregate.h"
#include "rules/verdict/judge_aggregates.h"

#include <string_view>
#include <vector>

namespace rules {

// Days before the end of a waiver from which on it is told.
inline constexpr int kSoon_days = 30;

// Warnings, one for each place in the project file. planes: of the space, judged, waivers applied;
// today: the day for which they were, YYYY-MM-DD.
//
// A waiver whose requirement passes on every plane that it is for is not needed. Those that waive
// something, stated deviations that are found, and zones that are left out, end soon.
void warn_about_waivers(const calc::Space& space, const std::vector<JudgedPlane>& planes,
                        std::string_view today, calc::Diagnostics& diagnostics);
// Likewise, of what is asked of buildings.
void warn_about_waivers(const std::vector<AggregateFinding>& buildings, std::string_view today,
                        calc::Diagnostics& diagnostics);

}  // namespace rules
