#pragma once
// Webs made from other webs.

#include "calc/photometry/web.h"
#include "tests/support/photometry_samples.h"

#include <functional>
#include <utility>
#include <vector>

namespace test_support {

inline calc::PhotometricWeb with_source(const calc::PhotometricWeb& web,
                                        const calc::LuminousOpening& opening,
                                        const calc::PhotometrySource& source) {
  std::vector<double> table;
  for (std::size_t p = 0; p < web.c_rad().size(); ++p) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) table.push_back(web.table_cd(p, g));
  }
  return calc::PhotometricWeb::make(web.c_rad(), web.gamma_rad(), table, opening, source,
                                    web.axis());
}

inline calc::PhotometricWeb with_opening(const calc::PhotometricWeb& web,
                                         const calc::LuminousOpening& opening) {
  return with_source(web, opening, web.source());
}

// About the line of C90, every 5 degrees, as type B has it: V and H from -90 to 90, dark above.
inline calc::PhotometricWeb lateral_web(const Light& cd_by_v_and_h) {
  std::vector<double> c_rad, gamma_rad, table;
  for (const double c : angle_steps(0, 360, 5)) {
    c_rad.push_back(c == 360.0 ? 2.0 * calc::kPi : calc::radians_from_degrees(c));
    const double v = c > 180.0 ? c - 360.0 : c;
    for (const double h : angle_steps(-90, 90, 5)) {
      table.push_back(v < -90.0 || v > 90.0 ? 0.0 : cd_by_v_and_h(v, h));
    }
  }
  for (const double gamma : angle_steps(0, 180, 5)) {
    gamma_rad.push_back(gamma == 180.0 ? calc::kPi : calc::radians_from_degrees(gamma));
  }
  return calc::PhotometricWeb::make(c_rad, gamma_rad, table, {}, {}, calc::TableAxis::lateral);
}

// A light without any symmetry, and the same made symmetric. cd by degrees; dark from gamma 90.
inline double crooked_light(double c_deg, double gamma_deg) {
  if (gamma_deg >= 90.0) return 0.0;
  const double around = 1.0 + 0.5 * cos_deg(c_deg) + 0.3 * sin_deg(2.0 * c_deg - 20.0);
  return 1000.0 * cos_deg(gamma_deg) * (1.0 + sin_deg(gamma_deg) * around);
}
inline Light symmetric_about_c0(const Light& light) {
  return [light](double c, double gamma) { return light(c > 180.0 ? 360.0 - c : c, gamma); };
}
inline Light symmetric_about_c90(const Light& light) {
  return [light](double c, double gamma) {
    return light(c > 90.0 && c < 270.0 ? 540.0 - c : c, gamma);  // 180 - c, on the side of C0
  };
}

}  // namespace test_support
