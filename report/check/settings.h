#pragma once
// The settings of a check, beside the project itself.

#include "calc/base/budget.h"
#include "calc/radiosity/gather/settings.h"
#include "report/check/selection.h"
#include "rules/catalogue/goal.h"

#include <string>

namespace check {

struct Settings {
  rules::Goal goal = rules::Goal::verdict;
  double tolerance = 0.02;   // relative half-width aimed at where nothing is decided, in (0, 1)
  double confidence = 0.95;  // of the intervals, over all sampling rounds of a plane; in (0.5, 1)
  calc::RadiositySettings radiosity;
  bool by_luminaire = false;  // light of single luminaires is kept apart and reported
  bool has_times = false;     // seconds of each phase go into the document
  calc::Budget budget;        // of each project; changes no result, only whether there is one
  Selection selection;        // of what each project requires
  std::string today;          // "2026-05-31", by which waivers end; "" = the clock's, UTC
};

// Returns the day; today's, by the clock in UTC, if it is empty.
std::string day_or_today(const std::string& day);
inline std::string day_of(const Settings& settings) { return day_or_today(settings.today); }

// Returns "" if all values are allowed, else the wrong value and the allowed ones.
std::string problem_with(const Settings& settings);

}  // namespace check
