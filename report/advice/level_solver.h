#pragma once
// Finds the least costly dimming levels that meet linear conditions.

#include "rules/measure/level_conditions.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cli {

struct LevelRange {
  double low = 0.0, high = 1.0;
};

struct LevelProblem {
  std::vector<double> cost;       // [group], of a level of 1, > 0
  std::vector<LevelRange> range;  // [group], whole steps
  int steps = 100;                // levels are multiples of 1 / steps; 0: any number
  std::function<bool()> is_stopped = [] { return false; };  // asked between the solver's runs
};

struct ConditionPrice {
  rules::LevelCondition condition;
  double cost_per_lx = 0.0;  // > 0: how much the least cost grows where it asks for more
};

struct Levels {
  std::vector<double> level;  // [group]
  double cost = 0.0;
  double least_cost = 0.0;  // no levels that meet the conditions cost less
  // The conditions that determine the least cost, for levels of any size, whatever the steps. Dual
  // values of the linear program; if several conditions are equal, of one of them.
  std::vector<ConditionPrice> price;
};

// Returns conditions that levels break. It is called repeatedly, because only few of all conditions
// matter; the worst condition is enough. Empty: all are met.
using BrokenConditions =
    std::function<std::vector<rules::LevelCondition>(const std::vector<double>& level)>;

// The answer. The same input gives the same levels: they depend neither on time nor on other
// threads. Requires that solver_problem() is "".
struct LevelAnswer {
  std::optional<Levels> levels;
  // Without levels: true if there are none. False: the search ended before it knew.
  bool is_proven_none = false;
};
LevelAnswer least_levels(const LevelProblem& problem, const BrokenConditions& broken);

// Returns why no levels can be searched here, and what to install; "" = they can.
std::string solver_problem();

}  // namespace cli
