#pragma once
// Cubic interpolation of a web, as an alternative to bilinear.

#include "calc/photometry/web.h"

namespace calc {

// Returns the same light with piecewise cubic Hermite interpolation between the tabulated angles,
// along gamma in each plane, then along C. Slopes are limited so that nothing overshoots: where the
// table rises the curve rises, and it never turns negative [FB84]. The curve is a finer table, 8
// parts to each step of gamma and 4 to each step of C, so that flux, sampling and all proofs are
// those of any web; between its entries it is bilinear, which leaves a 64th (gamma) and a 16th (C)
// of the difference between bilinear and cubic interpolation.
PhotometricWeb hermite_refined(const PhotometricWeb& web);

struct InterpolationDifference {
  double largest_share;  // of the maximum intensity, between the two interpolations
  double flux_share;     // cubic over bilinear flux, minus 1
};
InterpolationDifference interpolation_difference(const PhotometricWeb& web);

}  // namespace calc
