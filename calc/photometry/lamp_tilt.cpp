#include "calc/photometry/lamp_tilt.h"

#include "calc/base/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace calc {

double lamp_tilt_rad(const LampTilt& tilt, const glm::dmat3& world_from_luminaire) {
  if (tilt.geometry == 2) {
    return calc::asin(std::clamp(std::abs(world_from_luminaire[0].z), 0.0, 1.0));
  }
  // atan2 keeps the angle of a luminaire that points straight down exactly 0.
  const glm::dvec3& up = world_from_luminaire[2];
  return calc::atan2(calc::hypot(up.x, up.y), up.z);
}

bool covers(const LampTilt& tilt, double tilt_rad) {
  constexpr double kRounding_rad = 1.0e-9;
  return tilt_rad >= tilt.angle_rad.front() - kRounding_rad &&
         tilt_rad <= tilt.angle_rad.back() + kRounding_rad;
}

double tilt_factor(const LampTilt& tilt, double tilt_rad) {
  const std::vector<double>& angle = tilt.angle_rad;
  if (tilt_rad <= angle.front()) return tilt.factor.front();
  if (tilt_rad >= angle.back()) return tilt.factor.back();
  const auto after = std::upper_bound(angle.begin(), angle.end(), tilt_rad);
  const auto i = static_cast<std::size_t>(after - angle.begin()) - 1;
  return std::lerp(tilt.factor[i], tilt.factor[i + 1],
                   (tilt_rad - angle[i]) / (angle[i + 1] - angle[i]));
}

}  // namespace calc
