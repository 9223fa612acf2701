#include "report/text/luminaire_aim.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace report {

LuminaireAim aim_of(const LuminaireMark& mark) {
  constexpr double kDegrees = 180.0 / calc::kPi;
  constexpr double kKnown = 0.5;          // unit vectors, or 0
  constexpr double kLeastShare = 1.0e-3;  // of C0 in the plan: less is a rounded upright
  constexpr double kRounding_deg = 1.0e-9;
  LuminaireAim aim;
  if (glm::length(mark.axis) > kKnown)
    aim.tilt_deg = kDegrees * calc::acos(std::clamp(-mark.axis.z, -1.0, 1.0));
  const glm::dvec2 c0(mark.c0);
  if (glm::length(c0) > kLeastShare) {
    const double turn_deg = kDegrees * calc::atan2(c0.y, c0.x);
    const bool is_zero = std::abs(turn_deg) < kRounding_deg;
    aim.turn_deg = is_zero ? 0.0 : turn_deg < 0.0 ? turn_deg + 360.0 : turn_deg;
  }
  return aim;
}

}  // namespace report
