#pragma once
// Measures a luminaire's photometry: peak, beam and field angle, symmetry. All of it is read
// through PhotometricWeb::intensity_cd().

#include "calc/photometry/full_circle.h"
#include "calc/photometry/web.h"

#include <vector>

namespace calc {

// Returns whether intensity_cd(C, gamma) at the table's own angles is the table, to 1e-9 of the
// maximum (without the poles, where a web holds means).
bool has_c_gamma_table(const PhotometricWeb& web);

// C in [0, 2 pi) and gamma in [0, pi], ascending: the table's own angles, between which the light
// is bilinear, so that measures taken there are exact; steps of 1 and 0.5 degrees for a web that is
// not tabulated over C and gamma. C is {0} for an axial web.
struct MeasureAngles {
  std::vector<double> c_rad, gamma_rad;
};
MeasureAngles measure_angles(const PhotometricWeb& web);

// The highest intensity and its direction. Among equal ones (to 1e-9) the smallest gamma, then the
// smallest C counts; at a pole C is 0.
struct Peak {
  double intensity_cd = 0.0;
  double c_rad = 0.0, gamma_rad = 0.0;
};
Peak peak_of(const PhotometricWeb& web);

// The extent of directions whose intensity is at least a share of the highest IN THE SAME plane
// pair C and C + pi, a full circle through nadir and zenith. Share 0.5 is the beam angle, 0.1 the
// field angle.
struct BeamWidth {
  int lobes = 0;        // separate arcs of such directions; 0: no light in this plane pair
  double lobe_rad = 0;  // width of the arc that holds the highest intensity
  double span_rad = 0;  // of the smallest arc that holds all of them; equals lobe_rad for one lobe
  double from_rad = 0;  // ends of the lobe: signed gamma, < 0 on the side of C + pi; `to_rad` may
  double to_rad = 0;    // exceed pi when the lobe goes over the zenith
};
// Returns the width. c_rad: the plane that counts as positive. share: in (0, 1].
BeamWidth beam_width(const PhotometricWeb& web, double c_rad, double share);

// The largest differences between directions that a symmetry makes equal, as a share of the web's
// maximum: 0 for a light with this symmetry.
struct SymmetryFit {
  double axial = 0.0;     // all C
  double c0_c180 = 0.0;   // C and -C
  double c90_c270 = 0.0;  // C and pi - C
};
SymmetryFit symmetry_fit(const PhotometricWeb& web);
// Returns the highest symmetry that holds within this share of the maximum.
PlaneSymmetry symmetry_within(const SymmetryFit& fit, double share);
inline constexpr double kExactSymmetry = 1.0e-9;

// Returns about half the width of the narrowest relevant beam: at every angle of the table with
// more than a twentieth of the highest intensity, along gamma and along C, the light is at most 2.5
// times its mean over 2.5 of that to either side (a sharp edge has 2). Infinite from kWideBeam_rad
// on; never below half a degree.
double narrowest_beam_rad(const PhotometricWeb& web);
inline constexpr double kWideBeam_rad = 0.195;  // 11.2 degrees

// Returns the flux below the horizon over the total flux.
double downward_share(const PhotometricWeb& web);

}  // namespace calc
