#pragma once
// The least costly dimming levels that meet linear conditions.

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
  // Of levels of any size, whatever the steps: what holds the least cost up. Dual values of the
  // linear program; where several conditions say the same, of one of them.
  std::vector<ConditionPrice> price;
};

// What levels break: asked again and again, as of all conditions only few matter. The worst of
// them is enough. Empty: all are met.
using BrokenConditions =
    std::function<std::vector<rules::LevelCondition>(const std::vector<double>& level)>;

// The same input gives the same levels: nothing hangs on time, nor on other threads that ask.
// solver_problem() is "".
struct LevelAnswer {
  std::optional<Levels> levels;
  // Without levels: there are none. False: the search ended before it knew.
  bool is_proven_none = false;
};
LevelAnswer least_levels(const LevelProblem& problem, const BrokenConditions& broken);

// Why no levels can be looked for here, and what to install; "" = they can.
std::string solver_problem();

}  // namespace cli
