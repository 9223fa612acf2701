#pragma once
// What is asked of the rooms of a building together: their power or energy over their floors.

#include "calc/scene/project.h"
#include "rules/catalogue/aggregate.h"
#include "rules/catalogue/requirement.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

// Whether rooms have it together: power and energy add up over them, nothing else does.
constexpr bool adds_up_over_rooms(Metric metric) {
  return metric == Metric::power_density || metric == Metric::leni;
}

// Unique in a project: "tower/LENI".
std::string building_finding_id(const std::string& building, const std::string& requirement);

struct BuildingQuestion {
  std::size_t building = 0;  // in Project::buildings
  Requirement requirement;   // adds_up_over_rooms(); of no plane
};

// One finding each, in order. No light is in it: installed power is that of full output, energy by
// the hours and factors that the project states. Where that of a single room is not known, nothing
// is said of all of them. today: YYYY-MM-DD, for waivers.
std::vector<AggregateFinding> judge_buildings(const calc::Project& project,
                                              const std::vector<BuildingQuestion>& questions,
                                              std::string_view today);

}  // namespace rules
