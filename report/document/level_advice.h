#pragma once
// Dimming levels that would make a project pass, for reports: see check --advice.

#include "calc/base/message.h"
#include "calc/base/names.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Advice never raises the luminaires' light by more than this factor.
inline constexpr double kMostAdvisedLight = 20.0;

enum class AdviceOutcome {
  levels,         // these levels meet everything that depends on them
  contradiction,  // surely none up to full output do; these requirements exclude each other
  more_light,     // only with more light than the luminaires have
  too_uncertain,  // some may, but the intervals are too wide to tell
  none_found,     // the search ended, or its levels did not pass the check
};

// The quantity that advised levels minimize.
enum class CostUnit {
  watt,
  lumen,          // the power of a luminaire is not known
  kilowatt_hour,  // of a year
};

struct AdvisedGroup {
  std::string group;  // "" = luminaires without one
  std::size_t luminaires = 0;
  double power_w = 0.0, flux_lm = 0.0;  // of all of them at full output
  double energy_kwh = 0.0;              // likewise, of a year; 0 = a room does not state its use
  double now = 1.0;                     // level in the project
  double level = 1.0;                   // advised; above 1: so many times the light
};

// Names a requirement by ids.
struct RequirementName {
  std::string plane, requirement;
};

// The advice for one light scene.
struct LevelAdvice {
  std::string scene;  // "" = full output
  AdviceOutcome outcome = AdviceOutcome::none_found;
  calc::Message reason;  // of none_found, in words
  CostUnit unit = CostUnit::watt;
  // The quantity at the current levels and at the advised ones; 0 without levels.
  double now = 0.0, advised = 0.0;
  std::vector<AdvisedGroup> groups;  // of levels and more_light
  // Counts of the scene's requirements that count: passing with these levels, checked with other
  // random numbers; for more_light with the same light. 0 without levels.
  std::size_t passing = 0, asked = 0;
  std::vector<RequirementName> not_met;         // of them
  std::vector<std::string> aggregates_not_met;  // of rule packs, likewise, in words
  std::vector<RequirementName> excluding;       // of these no levels meet all

  bool has_levels() const {
    return outcome == AdviceOutcome::levels || outcome == AdviceOutcome::more_light;
  }
};

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::CostUnit> {
  static constexpr EnumName<report::CostUnit> list[] = {{report::CostUnit::watt, "W"},
                                                        {report::CostUnit::lumen, "lm"},
                                                        {report::CostUnit::kilowatt_hour, "kWh"}};
};

template <>
struct EnumNames<report::AdviceOutcome> {
  static constexpr EnumName<report::AdviceOutcome> list[] = {
      {report::AdviceOutcome::levels, "levels"},
      {report::AdviceOutcome::contradiction, "contradiction"},
      {report::AdviceOutcome::more_light, "more-light"},
      {report::AdviceOutcome::too_uncertain, "too-uncertain"},
      {report::AdviceOutcome::none_found, "none-found"}};
};

}  // namespace calc
