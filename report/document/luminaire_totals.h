#pragma once
// What luminaires add up to: in a schedule, in a room, in a project. All formats tell these numbers
// and no others. What counts is what the model holds: every luminaire that is drawn.

#include "report/document/document.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace report {

// Of several luminaires together.
struct LuminaireTotals {
  std::int64_t count = 0;           // each type alone may have as many as an int holds
  double flux_lm = 0, power_w = 0;  // of those that state it
  bool is_power_known = true;       // of each of them
};

// Of all types of a project.
LuminaireTotals totals_of(const std::vector<LuminaireRow>& luminaires);

// Of a space of the project. Of a road these are all that are drawn, where SpacePart::power has
// those of one spacing alone.
LuminaireTotals totals_in(const ProjectPart& project, const SpacePart& space);

// Of the project, without those of its spaces: a report of a run that was cut short lacks spaces.
LuminaireTotals totals_elsewhere(const ProjectPart& project);

// Of a space: luminaires that are lit in scenes by which emergency lighting is judged, and that all
// other scenes switch off. Nothing where there is no other scene: then nobody says that they are
// off. Power and energy of the space include them.
LuminaireTotals totals_of_emergency(const ProjectPart& project, const SpacePart& space);

// Whether SpacePart::power is that of one spacing of a road. Results of earlier versions say it by
// their numbers alone.
bool is_power_of_spacing(const SpacePart& space);

// By which schedules and plans name a type: "A" to "Z", then "AA" and so on, in the order of the
// schedule.
std::string position_letter(std::size_t row);

}  // namespace report
