#pragma once
// Warns of waivers in time: that they end soon, or are not needed any more.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"
#include "rules/catalogue/aggregate.h"
#include "rules/verdict/judge_aggregates.h"

#include <string_view>
#include <vector>

namespace rules {

// The warning starts this many days before the end of a waiver.
inline constexpr int kSoon_days = 30;

// Reports warnings, one for each place in the project file. planes: of the space, judged, waivers
// applied; today: the day for which they were, YYYY-MM-DD.
//
// A waiver is not needed if its requirement passes on all its planes. Waivers that waive something,
// stated deviations that are found, and omitted zones end soon.
void warn_about_waivers(const calc::Space& space, const std::vector<JudgedPlane>& planes,
                        std::string_view today, calc::Diagnostics& diagnostics);
// Reports the same warnings for requirements on buildings.
void warn_about_waivers(const std::vector<AggregateFinding>& buildings, std::string_view today,
                        calc::Diagnostics& diagnostics);

}  // namespace rules
