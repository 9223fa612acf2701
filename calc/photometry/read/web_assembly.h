#pragma once
// From a file's table to a web: the checks that both formats share, and the expansion to the full
// circle.

#include "calc/base/diagnostics.h"
#include "calc/photometry/full_circle.h"
#include "calc/photometry/web.h"

#include <optional>
#include <vector>

namespace calc {

// A luminaire gives no more light than its lamps; 2 % are what files round away.
inline constexpr double kEfficiencyLimit = 1.02;

// As in the file: degrees, stored planes only, all factors applied. Counts fit, angles ascend
// within their ranges and intensities are finite (readers check those, they know the lines).
struct FileTable {
  std::vector<double> c_deg;  // as full_circle() wants them
  PlaneSymmetry symmetry = PlaneSymmetry::none;
  TableAxis axis = TableAxis::vertical;  // lateral: c_deg and gamma_deg are the table's
  bool lists_c360 = false;  // the format repeats plane 0 at 360 when there is no symmetry
  std::vector<double> gamma_deg;
  std::vector<double> intensity_cd;  // [plane][gamma]
  // The greatest at angles where the list ends and its format has it go on, so that the file leaves
  // open what is beyond. Of other tables than types A and B make_checked_web() finds it.
  double at_open_ends_cd = 0.0;
  SourceLocation where;                // where the table starts
  SourceLocation most_negative_where;  // of the smallest value
};

// Empty if and only if an error was reported: no light at all, more than measurement noise below
// zero, absurdly high values (of the light, the opening, the rated flux or the power), or planes
// missing. Warns of what a reader of the results should know: noise set to 0, a gap in the angles,
// planes that disagree at a pole or at C 0 and 360.
std::optional<PhotometricWeb> make_checked_web(FileTable table, const LuminousOpening& opening,
                                               PhotometrySource source, Diagnostics& diagnostics);

// Angles within [lowest_deg, highest_deg] that ascend by at least 1e-6 degrees; previous: the angle
// before, or nullptr. Reports and returns false otherwise. what: "vertical", "C" ...
bool check_angle(double deg, const double* previous, double lowest_deg, double highest_deg,
                 const char* what, const SourceLocation& where, Diagnostics& diagnostics);

// Of a format whose tables hold candelas: warns if they look like candelas per 1000 lm, which are
// too dark by as much as the lamps have more than 1000 lm. rated_lm: of all lamps; 0: not stated.
void warn_of_low_flux(double flux_lm, double rated_lm, const SourceLocation& where,
                      Diagnostics& diagnostics);

}  // namespace calc
