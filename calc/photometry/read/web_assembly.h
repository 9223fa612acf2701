#pragma once
// Makes a web from a file's table: the checks that all formats share, and the expansion to the full
// circle.

#include "calc/base/diagnostics.h"
#include "calc/photometry/full_circle.h"
#include "calc/photometry/web.h"

#include <optional>
#include <vector>

namespace calc {

// Limits light output over lamp flux, which cannot exceed 1; files may round it up by 2 %.
inline constexpr double kEfficiencyLimit = 1.02;

// The table in the file: degrees, stored planes only, all factors applied. Counts fit, angles
// ascend within their ranges and intensities are finite (readers check those with their lines).
struct FileTable {
  std::vector<double> c_deg;  // as full_circle() wants them
  PlaneSymmetry symmetry = PlaneSymmetry::none;
  TableAxis axis = TableAxis::vertical;  // lateral: c_deg and gamma_deg are the table's
  bool lists_c360 = false;  // the format repeats plane 0 at 360 when there is no symmetry
  std::vector<double> gamma_deg;
  std::vector<double> intensity_cd;  // [plane][gamma]
  // The highest intensity at ends of the list beyond which the format allows more light, so that
  // the file leaves it open. make_checked_web() finds it, except for types A and B.
  double at_open_ends_cd = 0.0;
  SourceLocation where;                // where the table starts
  SourceLocation most_negative_where;  // of the smallest value
};

// Returns the web; empty if and only if an error was reported: no light at all, negative values
// beyond measurement noise, absurdly high values (of the light, the opening, the rated flux or the
// power), or missing planes. Warns of noise set to 0, a gap in the angles, and planes that disagree
// at a pole or at C 0 and 360.
std::optional<PhotometricWeb> make_checked_web(FileTable table, const LuminousOpening& opening,
                                               PhotometrySource source, Diagnostics& diagnostics);

// Returns whether an angle is within [lowest_deg, highest_deg] and at least 1e-6 degrees above the
// previous one (nullptr: none); else reports it. what: "vertical", "C" ...
bool check_angle(double deg, const double* previous, double lowest_deg, double highest_deg,
                 const char* what, const SourceLocation& where, Diagnostics& diagnostics);

// Warns if a table of candelas looks like candelas per 1000 lm, which would be too dark by the
// lamps' flux over 1000 lm. rated_lm: of all lamps; 0: not stated.
void warn_of_low_flux(double flux_lm, double rated_lm, const SourceLocation& where,
                      Diagnostics& diagnostics);

}  // namespace calc
