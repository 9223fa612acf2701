#pragma once
// The energy of a space's luminaires in a year, by the factors of EN 15193.
//
//   W = sum over luminaires of P Fc (tD Fo FD + tN Fo) / 1000,  LENI = W / A + parasitic energy
//
// P in W, t in h, W in kWh, A in m2, LENI in kWh/m2 and year. [EN 15193-1; formula from two public
// sources]

#include "calc/base/message.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/project.h"

#include <map>
#include <optional>
#include <string>

namespace calc {

struct LightingEnergy {
  double lighting_kwh = 0.0;  // in a year, without the parasitic part
  double leni_kwh_m2 = 0.0;   // with it
  Message problem;            // why there is no LENI; the numbers are then 0. "" = there is one
  // The inputs, with every factor that is not stated as 1; "" with a problem.
  Message words;
  // lighting_kwh by dimming group; "" = luminaires without a group. Results omit it.
  std::map<std::string, double> kwh_of_group = {};
};

// Returns the energy of luminaires at full output, whatever the scene. power: of the space.
LightingEnergy lighting_energy(const Project& project, const Space& space,
                               const InstalledPower& power);

}  // namespace calc
