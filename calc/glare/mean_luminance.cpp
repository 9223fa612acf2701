#include "calc/glare/mean_luminance.h"

#include "calc/scene/opening.h"

#include <limits>

namespace calc {
namespace {

LuminousOpening with_sides(LuminousOpening opening) {
  if (!(opening.height_m > 0.0)) return opening;
  if (opening.shape == OpeningShape::rectangle) opening.shape = OpeningShape::box;
  if (opening.shape == OpeningShape::disk) opening.shape = OpeningShape::cylinder;
  return opening;
}

}  // namespace

MeanLuminance::MeanLuminance(const PhotometricWeb& web) {
  luminaire_.web = &web;
  luminaire_.opening = with_sides(web.opening());
}

double MeanLuminance::area_m2(const glm::dvec3& towards) const {
  return has_area() ? seen_opening_m2(luminaire_, towards) : 0.0;
}

double MeanLuminance::intensity_cd(const glm::dvec3& towards) const {
  return luminaire_.web->intensity_cd({towards.x, towards.y, towards.z});
}

double MeanLuminance::luminance_cd_m2(double c_rad, double gamma_rad) const {
  const std::array<double, 3> out = direction_of({c_rad, gamma_rad});
  const double area = area_m2({out[0], out[1], out[2]});
  return area > 0.0 ? luminaire_.web->intensity_cd(out) / area
                    : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace calc
