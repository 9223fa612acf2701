#pragma once
// Totals of luminaires: in a schedule, in a room, in a project. All formats use these numbers. They
// count every luminaire in the model.

#include "report/document/document.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace report {

// Totals of several luminaires.
struct LuminaireTotals {
  std::int64_t count = 0;           // each type alone may have as many as an int holds
  double flux_lm = 0, power_w = 0;  // of those that state it
  bool is_power_known = true;       // of each of them
};

// Returns the totals of all types of a project.
LuminaireTotals totals_of(const std::vector<LuminaireRow>& luminaires);

// Returns the totals of a space of the project. For a road they include all drawn luminaires, while
// SpacePart::power has those of one spacing.
LuminaireTotals totals_in(const ProjectPart& project, const SpacePart& space);

// Returns the totals of the project without those of its spaces: a report of an interrupted run
// lacks spaces.
LuminaireTotals totals_elsewhere(const ProjectPart& project);

// Returns the totals of the luminaires of a space that are lit in scenes by which emergency
// lighting is judged, and off in all other scenes. Nothing if there is no other scene, because
// nothing then says that they are off. Power and energy of the space include them.
LuminaireTotals totals_of_emergency(const ProjectPart& project, const SpacePart& space);

// Returns whether SpacePart::power is that of one spacing of a road. In results of earlier versions
// only the numbers show it.
bool is_power_of_spacing(const SpacePart& space);

// Returns the letter of a type in schedules and plans: "A" to "Z", then "AA" and so on, in the
// order of the schedule.
std::string position_letter(std::size_t row);

}  // namespace report
