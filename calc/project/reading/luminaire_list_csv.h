#pragma once
// Reads luminaires from a CSV file, e.g. a schedule out of a CAD program.

#include "calc/base/diagnostics.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct LuminaireEntry {
  std::string name, type, group;  // group "" = none
  glm::dvec3 position_m{0.0};
  std::optional<glm::dvec3> axis, aim_m;  // at most one of them; axis as written, not zero
  double rotation_rad = 0.0;
  int line = 0;
};

struct LuminaireList {
  std::string file;
  std::vector<LuminaireEntry> entry;  // at least one, no name twice
};

// Reads a table whose first line names the columns, in any order: name, type, x_m, y_m, z_m;
// optional axis_x, axis_y, axis_z or aim_x_m, aim_y_m, aim_z_m (all three of a luminaire may be
// empty: straight down), rotation_deg (empty: 0), group; x_mm, aim_x_mm and so on, all in one unit
// of units.h, instead of metres. Values are separated by commas and may be quoted (csv.h), numbers
// have a decimal point; empty lines are skipped. name: path used in messages. Empty if and only if
// an error was reported.
std::optional<LuminaireList> parse_luminaire_list(std::string_view bytes, const std::string& name,
                                                  Diagnostics& diagnostics);

}  // namespace calc
