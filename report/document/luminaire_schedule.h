#pragma once
// The luminaires of a project as in a tender: a line for each type in use.

#include "report/document/document.h"
#include "report/document/luminaire_totals.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace report {

// One line of the schedule. It points into the project.
struct ScheduleRow {
  const LuminaireRow* type = nullptr;
  std::string position;  // see position_letter()
  // Outline of the luminous opening, along C0 and C90 around its centre; empty: a point, or not
  // known.
  std::vector<glm::dvec2> outline_m = {};
  glm::dvec2 opening_m{0.0};  // its sides; 0: likewise
  // Heights of the openings' centres, each once, ascending, to the centimetre: above the floor in
  // rooms with a floor plan, otherwise above z = 0.
  std::vector<double> heights_m = {}, heights_above_zero_m = {};
  std::vector<const SpacePart*> spaces = {};  // where it is, in the project's order
};

struct LuminaireSchedule {
  std::vector<ScheduleRow> used, unused;  // described but nowhere: no part of any sum
  LuminaireTotals totals;
  std::vector<const SpacePart*> roads;  // with luminaires, see is_power_of_spacing()
};

// Returns the schedule, which is valid as long as the project.
LuminaireSchedule schedule_of(const ProjectPart& project);

}  // namespace report
