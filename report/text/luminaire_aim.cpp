#include "report/text/luminaire_aim.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/text/text_numbers.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace report {

namespace {

constexpr double kDegrees = 180.0 / calc::kPi;

double rounded(double degrees) { return std::round(degrees * 1.0e6) / 1.0e6; }

std::optional<double> seen_from_above_deg(const glm::dvec3& direction) {
  constexpr double kLeastShare = 1.0e-3;  // in the plan: less is a rounded upright
  const glm::dvec2 flat(direction);
  if (!(glm::length(flat) > kLeastShare)) return std::nullopt;
  const double degrees = rounded(kDegrees * calc::atan2(flat.y, flat.x));
  return degrees < 0.0 ? degrees + 360.0 : std::abs(degrees);
}

}  // namespace

LuminaireAim aim_of(const LuminaireMark& mark) {
  constexpr double kKnown = 0.5;  // unit vectors, or 0
  LuminaireAim aim;
  if (glm::length(mark.axis) > kKnown)
    aim.tilt_deg = rounded(kDegrees * calc::acos(std::clamp(-mark.axis.z, -1.0, 1.0)));
  aim.heading_deg = seen_from_above_deg(mark.axis);
  aim.turn_deg = seen_from_above_deg(mark.c0);
  return aim;
}

std::string aim_words(const Texts& t, const LuminaireAim& aim) {
  const auto degrees = [&](double angle_deg) { return format_fixed(t, angle_deg, 1) + "°"; };
  if (!aim.tilt_deg) return {};
  return degrees(*aim.tilt_deg) + (aim.heading_deg ? " → " + degrees(*aim.heading_deg) : "");
}

}  // namespace report
