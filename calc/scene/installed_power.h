#pragma once
// Installed power of a space's luminaires.

#include "calc/base/message.h"
#include "calc/scene/project.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace calc {

// Power at full output; for a road that of one field, from one luminaire of a row to the next. The
// project's statement comes before the photometry file's.
struct InstalledPower {
  double power_w = 0.0;   // of the luminaires that state it
  double area_m2 = 0.0;   // of the room's floor; 0 = not known
  int luminaires = 0;     // all
  int without_power = 0;  // of them: their power is not stated
  // Those of them whose photometry states a power for a flux other than the project's. Results omit
  // it.
  int of_other_flux = 0;
  // For a road: the values are for one spacing, where more luminaires are drawn.
  bool is_of_spacing = false;
  // Counts by dimming group ("" = none) and type id. Results omit it.
  std::map<std::pair<std::string, std::string>, std::size_t> luminaires_of = {};

  // Returns why there is no power density; "" if there is one.
  Message problem() const;
  std::optional<double> density_w_m2() const;  // empty with a problem
};

// Returns W/m2 for each 100 lx of an average > 0.
inline double power_per_100_lx_w_m2(double density_w_m2, double average_lx) {
  return 100.0 * density_w_m2 / average_lx;
}

// Requires the types of the space's luminaires in project.luminaire_types.
InstalledPower installed_power(const Project& project, const Space& space);

}  // namespace calc
