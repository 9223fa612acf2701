#pragma once
// Judges requirements on all rooms of a building together: their power or energy over their floors.

#include "calc/scene/project.h"
#include "rules/catalogue/aggregate.h"
#include "rules/catalogue/requirement.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

// Returns whether the metric adds up over rooms: only power and energy do.
constexpr bool adds_up_over_rooms(Metric metric) {
  return metric == Metric::power_density || metric == Metric::leni;
}

// Returns an id that is unique in a project: "tower/LENI".
std::string building_finding_id(const std::string& building, const std::string& requirement);

struct BuildingQuestion {
  std::size_t building = 0;  // in Project::buildings
  Requirement requirement;   // adds_up_over_rooms(); of no plane
};

// Returns one finding for each, in order, without any light calculation: installed power is that of
// full output, energy follows the stated hours and factors. If a single room's value is not known,
// there is no total. today: YYYY-MM-DD, for waivers.
std::vector<AggregateFinding> judge_buildings(const calc::Project& project,
                                              const std::vector<BuildingQuestion>& questions,
                                              std::string_view today);

}  // namespace rules
