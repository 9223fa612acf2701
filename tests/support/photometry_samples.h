#pragma once
// Small photometry files and webs written by formula, so that tests know the light they describe.

#include "calc/base/units.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/web.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

// Intensity by C and gamma in degrees.
using Light = std::function<double(double c_deg, double gamma_deg)>;

inline double sin_deg(double deg) { return std::sin(calc::radians_from_degrees(deg)); }
inline double cos_deg(double deg) { return std::cos(calc::radians_from_degrees(deg)); }

// first, first + step, ... last
inline std::vector<double> angle_steps(double first_deg, double last_deg, double step_deg) {
  std::vector<double> angles;
  const int count = static_cast<int>(std::lround((last_deg - first_deg) / step_deg));
  for (int i = 0; i <= count; ++i) angles.push_back(first_deg + step_deg * i);
  return angles;
}

// c_deg: {0} or 0 to 360.
inline calc::PhotometricWeb make_web(const std::vector<double>& c_deg,
                                     const std::vector<double>& gamma_deg, const Light& cd) {
  std::vector<double> c_rad, gamma_rad, table;
  for (const double c : c_deg) {
    c_rad.push_back(c == 360.0 ? 2.0 * calc::kPi : calc::radians_from_degrees(c));
    for (const double gamma : gamma_deg)
      table.push_back(std::max(0.0, cd(c == 360.0 ? 0.0 : c, gamma)));
  }
  for (const double gamma : gamma_deg) {
    gamma_rad.push_back(gamma == 180.0 ? calc::kPi : calc::radians_from_degrees(gamma));
  }
  return calc::PhotometricWeb::make(c_rad, gamma_rad, table, {}, {});
}

// A beam of Gaussian shape around nadir, a wall washer towards C 90, and a batwing, weak below.
inline double narrow_spot(double, double gamma_deg) {
  return 5.0e4 * std::exp(-gamma_deg * gamma_deg / 8.0);
}
inline double wall_washer(double c_deg, double gamma_deg) {
  const double towards_wall = sin_deg(gamma_deg) * sin_deg(c_deg) * 0.8 + cos_deg(gamma_deg) * 0.6;
  return towards_wall > 0.0 && gamma_deg < 90.0 ? 900.0 * std::pow(towards_wall, 6) : 0.0;
}
inline double batwing(double c_deg, double gamma_deg) {
  if (gamma_deg >= 90.0) return 0.0;
  const double across = 0.2 + 0.8 * sin_deg(c_deg) * sin_deg(c_deg);
  return 400.0 * cos_deg(gamma_deg) * (1.0 + 3.0 * across * std::pow(sin_deg(gamma_deg), 2));
}

struct IesSample {
  std::string tag = "IESNA:LM-63-2002";
  std::string keywords =
      "[TEST] sample\n[TESTLAB] none\n[ISSUEDATE] 01-JAN-2026\n[MANUFAC] luxgate "
      "examples\n[LUMINAIRE] formula\n";
  std::string tilt = "TILT=NONE\n";
  std::string lamps = "1 -1";
  std::string multiplier = "1";
  std::string type = "1";
  std::string opening = "2 0 0 0";  // units, width, length, height
  std::string factors = "1 1 10";   // ballast, field 12, watts
  std::vector<double> gamma_deg = angle_steps(0, 90, 5);
  std::vector<double> c_deg = {0};
  Light cd = [](double, double gamma) { return gamma < 90.0 ? 100.0 * cos_deg(gamma) : 0.0; };
  std::string tail;
};

inline std::string ies_text(const IesSample& sample) {
  std::string text = sample.tag + "\n" + sample.keywords + sample.tilt;
  text += fmt::format("{} {} {} {} {} {}\n{}\n", sample.lamps, sample.multiplier,
                      sample.gamma_deg.size(), sample.c_deg.size(), sample.type, sample.opening,
                      sample.factors);
  text += fmt::format("{}\n{}\n", fmt::join(sample.gamma_deg, " "), fmt::join(sample.c_deg, " "));
  for (const double c : sample.c_deg) {
    std::vector<double> plane;
    for (const double gamma : sample.gamma_deg) plane.push_back(sample.cd(c, gamma));
    text += fmt::format("{}\n", fmt::join(plane, " "));
  }
  return text + sample.tail;
}

struct LdtSample {
  std::string type = "3";
  std::string symmetry = "0";
  std::vector<double> all_c_deg = angle_steps(0, 345, 15);
  std::vector<double> stored_c_deg = angle_steps(0, 345, 15);  // in the order of the file
  std::vector<double> gamma_deg = angle_steps(0, 180, 5);
  std::string luminous_length_mm = "1200", luminous_width_mm = "300";
  std::string downward = "100", output_ratio = "100", conversion = "1", measured_tilt = "0";
  std::vector<std::string> lamp_set_lines = {"1",      "LED", "1000",
                                             "4000 K", "80",  "10"};  // 6 per set
  Light cd_per_klm = [](double, double gamma) {
    return gamma < 90.0 ? 1000.0 / calc::kPi * cos_deg(gamma) : 0.0;
  };
};

inline std::string ldt_text(const LdtSample& sample) {
  std::string text = fmt::format("luxgate examples\n{}\n{}\n{}\n0\n{}\n5\n", sample.type,
                                 sample.symmetry, sample.all_c_deg.size(), sample.gamma_deg.size());
  text += "report\nformula\nnumber\nfile\ndate\n1250\n320\n80\n";
  text += fmt::format("{}\n{}\n0\n0\n0\n0\n", sample.luminous_length_mm, sample.luminous_width_mm);
  text += fmt::format("{}\n{}\n{}\n{}\n{}\n", sample.downward, sample.output_ratio,
                      sample.conversion, sample.measured_tilt, sample.lamp_set_lines.size() / 6);
  for (const std::string& line : sample.lamp_set_lines) text += line + "\n";
  for (int i = 0; i < 10; ++i) text += "0.5\n";
  text +=
      fmt::format("{}\n{}\n", fmt::join(sample.all_c_deg, "\n"), fmt::join(sample.gamma_deg, "\n"));
  for (const double c : sample.stored_c_deg) {
    for (const double gamma : sample.gamma_deg)
      text += fmt::format("{}\n", sample.cd_per_klm(c, gamma));
  }
  return text;
}

// Every diagnostic as format_diagnostic() writes it, one per line.
inline std::string diagnostics_text(const calc::Diagnostics& diagnostics) {
  std::string text;
  for (const calc::Diagnostic& entry : diagnostics.all())
    text += calc::format_diagnostic(entry) + "\n";
  return text;
}

}  // namespace test_support
