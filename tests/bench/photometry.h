#pragma once
// Luminaires made by formula, for benchmarks.

#include "calc/photometry/web.h"

#include <string>
#include <vector>

namespace bench {

// An intensity table in degrees, as a file would hold it: the same numbers go into a web and into
// an IES file.
struct WebTable {
  std::string name;
  std::vector<double> c_deg;      // {0} or 0 to 360
  std::vector<double> gamma_deg;  // from 0
  std::vector<double> cd;         // [c][gamma]
};

// About cos^1.3 gamma, rotationally symmetric, nothing above 90 degrees.
WebTable wide_web(double flux_lm);
// cos^1.3 gamma with more light towards C 0 and C 90 than away from them: no symmetry at all.
WebTable asymmetric_web(double flux_lm);
// cos^n gamma with half its intensity at beam_deg / 2, nothing beyond five half widths.
WebTable spot_web(double flux_lm, double beam_deg);

calc::PhotometricWeb make_web(const WebTable& table);
// LM-63-2002, absolute photometry, a point opening.
std::string ies_text(const WebTable& table);

}  // namespace bench
