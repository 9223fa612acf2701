#pragma once
// Splits a batch into jobs that machines can calculate separately, and assigns them to shards. A
// result cache joins the results.

#include "calc/radiosity/gather/settings.h"
#include "report/check/plan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace check {

// A job: a space, or some planes of a large one.
struct Unit {
  std::string project;              // path
  std::string space;                // id
  std::vector<std::string> planes;  // ids, in their order: those that have points
  bool is_whole_space = true;
  std::size_t points = 0;
  // Predicted seconds of a core for the first sampling round; further rounds are not known before.
  // Counts of work times the costs of a fixed machine, so equal on every machine.
  double first_look_s = 0.0;
};

// Returns the units of all planned projects, in their order. A space predicted to take more than
// split_above_s is split between planes.
inline constexpr double kSplitAbove_s = 10.0;
std::vector<Unit> units_of(const std::vector<ProjectPlan>& projects,
                           const calc::RadiositySettings& settings,
                           double split_above_s = kSplitAbove_s);

// Returns "projects/a.xml: meeting", with planes "projects/a.xml: hall (desk1, desk2)".
std::string unit_name(const Unit& unit);

// Returns the shard of each unit, 0 .. count-1; count >= 1. The list is cut by the sum of predicted
// seconds, so that rooms of a project stay together and a shard reads few projects. No shard has
// more than an equal share and half of its first and of its last unit. Equal lists of units give
// equal shards.
std::vector<std::size_t> shards_of(const std::vector<Unit>& units, std::size_t count);

}  // namespace check
