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

// At full output; of a road that of one field, from one luminaire of a row to the next. Power is
// what the project states, else the photometry file.
struct InstalledPower {
  double power_w = 0.0;   // of the luminaires that state it
  double area_m2 = 0.0;   // of the room's floor; 0 = not known
  int luminaires = 0;     // all
  int without_power = 0;  // of them: nobody states their power
  // Of these: their photometry states a power, but for another flux than the project's. Results do
  // not have it.
  int of_other_flux = 0;
  // Of a road: one spacing of it, where more luminaires are drawn.
  bool is_of_spacing = false;
  // How many there are, by dimming group ("" = none) and type id. Results do not have it.
  std::map<std::pair<std::string, std::string>, std::size_t> luminaires_of = {};

  // Why there is no power density; "" = there is one.
  Message problem() const;
  std::optional<double> density_w_m2() const;  // empty with a problem
};

// W/m2 for each 100 lx of an average > 0.
inline double power_per_100_lx_w_m2(double density_w_m2, double average_lx) {
  return 100.0 * density_w_m2 / average_lx;
}

// project.luminaire_types must hold the types of the space's luminaires.
InstalledPower installed_power(const Project& project, const Space& space);

}  // namespace calc
