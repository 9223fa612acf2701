#pragma once
// The units of lengths and angles in an IFC file.

#include "report/tools/import/step_text.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct IfcUnits {
  double metres = 1.0;     // of one unit of length, > 0
  double per_metre = 0.0;  // units of a metre where that is the whole number; else 0
  double radians = 1.0;    // of one unit of angle, > 0
  bool has_angle = false;  // false: the file names no unit of angle, and radians are taken
  std::string name;        // "mm", "FOOT": as people say it
  std::string reason;      // where it is from
  std::vector<std::string> doubt;

  // Converts to metres, by division if possible: 5400 mm are 5.4 m to the last bit.
  double length_m(double value) const {
    return per_metre != 0.0 ? value / per_metre : value * metres;
  }
};

// Sets the unit of length; the only way to do so.
void set_length_unit(IfcUnits& units, double metres);

// Returns the units. Empty with a problem: no unit of length, two that differ, or one that is not
// understood.
std::optional<IfcUnits> read_ifc_units(const StepText& text, StepProblem& problem);

}  // namespace cli
