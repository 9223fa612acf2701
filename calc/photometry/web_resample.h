#pragma once
// Resamples a web about another axis over C and gamma, for formats that have no other axis.

#include "calc/photometry/web.h"

#include <optional>

namespace calc {

struct ResampledWeb {
  PhotometricWeb web;
  double c_step_deg, gamma_step_deg;
  double largest_share;  // largest difference found, of the web's maximum
  double flux_ratio;     // resampled over original
};

// Resamples at even steps: the coarsest of 5 x 2.5, 2.5 x 1 and 1 x 0.5 degrees (C x gamma;
// EULUMDAT holds no finer) that differs by less than 0.5 % of the maximum from the web, else the
// last. Compared at the angles of the web's own table and in the middle between the new ones. The
// table ends at gamma 90 if there is no light above. Empty for a beam so narrow that it falls
// between the finest angles.
std::optional<ResampledWeb> resampled_over_c_gamma(const PhotometricWeb& web);

}  // namespace calc
