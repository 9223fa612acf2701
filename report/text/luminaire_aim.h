#pragma once
// How a luminaire is turned, as fitters read it.

#include "report/document/document.h"

#include <optional>

namespace report {

// Degrees. tilt: of the axis (gamma = 0) from straight down, [0, 180]. turn: where C0 points as
// seen from above, counter-clockwise from +x, [0, 360). Empty: not known, or C0 points up or down.
struct LuminaireAim {
  std::optional<double> tilt_deg, turn_deg;
};

LuminaireAim aim_of(const LuminaireMark& mark);

}  // namespace report
