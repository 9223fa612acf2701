#pragma once
// The orientation of a luminaire, in the form that fitters use.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <optional>
#include <string>

namespace report {

// Degrees, rounded to 1e-6. tilt: of the axis (gamma = 0) from straight down, [0, 180]. heading and
// turn: where the axis and C0 point as seen from above, counter-clockwise from +x, [0, 360). Empty:
// not known, or they point up or down.
struct LuminaireAim {
  std::optional<double> tilt_deg, heading_deg, turn_deg;
};

LuminaireAim aim_of(const LuminaireMark& mark);

// Returns "30.0° → 90.0°": tilt, and heading if there is one; "" = not known.
std::string aim_words(const Texts& t, const LuminaireAim& aim);

}  // namespace report
