#pragma once
// A batch in pieces that machines can calculate apart from each other, and how pieces are shared
// out. What is calculated meets again in a store of looks.

#include "calc/radiosity/gather/settings.h"
#include "report/check/plan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace check {

// A space, or some planes of a large one.
struct Unit {
  std::string project;              // path
  std::string space;                // id
  std::vector<std::string> planes;  // ids, in their order: those that have points
  bool is_whole_space = true;
  std::size_t points = 0;
  // One core's, for the first look: what decides how much has to follow is not known before.
  // Counts of work times costs of one machine, so the same on every machine.
  double first_look_s = 0.0;
};

// Of all projects that are planned, in their order. A space is split, between planes, where it is
// predicted to take more than split_above_s.
inline constexpr double kSplitAbove_s = 10.0;
std::vector<Unit> units_of(const std::vector<ProjectPlan>& projects,
                           const calc::RadiositySettings& settings,
                           double split_above_s = kSplitAbove_s);

// "projects/a.xml: meeting", with planes "projects/a.xml: hall (desk1, desk2)".
std::string unit_name(const Unit& unit);

// Which of `count` >= 1 shards each unit belongs to, 0 .. count-1. The list is cut where the sum of
// predicted seconds says, so that rooms of a project stay together: a shard reads few projects.
// None has more than an equal share and half of its first and of its last unit. Equal lists of
// units give equal shards.
std::vector<std::size_t> shards_of(const std::vector<Unit>& units, std::size_t count);

}  // namespace check
