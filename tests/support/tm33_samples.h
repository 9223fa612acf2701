#pragma once
// Small TM-33 files written by formula.

#include "tests/support/photometry_samples.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace test_support {

struct Tm33Emitter {
  std::string head =
      "<ID>led</ID><Quantity>1</Quantity><RatedLumens>320</RatedLumens>"
      "<InputWattage>3</InputWattage>";
  std::string symmetry = "Symm _ None";  // no element if empty
  std::string before_points = "<PhotometryType>CIE _ C</PhotometryType><Metric>Luminous</Metric>";
  std::vector<double> c_deg = angle_steps(0, 345, 15);
  std::vector<double> gamma_deg = angle_steps(0, 90, 5);
  Light cd = [](double, double gamma) { return gamma < 90.0 ? 100.0 * cos_deg(gamma) : 0.0; };
  std::string tail;
};

// One point a line, so that lines can be told.
inline std::string tm33_points(const Tm33Emitter& emitter) {
  std::string text;
  for (const double c : emitter.c_deg) {
    for (const double gamma : emitter.gamma_deg) {
      text += fmt::format("<IntensityData horz=\"{}\" vert=\"{}\">{}</IntensityData>\n", c, gamma,
                          emitter.cd(c, gamma));
    }
  }
  return text;
}

// The form found in files, <LuminousData> with <IntensityData>.
inline std::string tm33_emitter(const Tm33Emitter& emitter) {
  const std::string symmetry =
      emitter.symmetry.empty() ? "" : "<SymmType>" + emitter.symmetry + "</SymmType>";
  return "<Emitter>" + emitter.head + "<LuminousData>" + emitter.before_points + symmetry + "\n" +
         tm33_points(emitter) + "</LuminousData>" + emitter.tail + "</Emitter>\n";
}

// Line 1: root and head; points from line 3, those of the first emitter.
inline std::string tm33_text(const std::string& emitters, const std::string& luminaire =
                                                              "<LuminousOpening><Shape>Rectangular"
                                                              "</Shape><Length>600</Length><Width>"
                                                              "300</Width></LuminousOpening>") {
  return "<IESTM33-22><Version>1.1</Version><Header><Manufacturer>luxgate examples</Manufacturer>"
         "<Description>formula</Description></Header><Luminaire>" +
         luminaire + "</Luminaire>\n" + emitters + "</IESTM33-22>\n";
}

inline std::string tm33_text(const Tm33Emitter& emitter) {
  return tm33_text(tm33_emitter(emitter));
}

}  // namespace test_support
