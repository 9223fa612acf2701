#pragma once
// Samples directions distributed exactly as the web's interpolated intensity: density = intensity /
// flux per sr.

#include "calc/photometry/web.h"

#include <array>
#include <cstddef>
#include <vector>

namespace calc {

// Holds prefix sums for inversion. Built once per web; the web must outlive it.
class WebSampler {
 public:
  explicit WebSampler(const PhotometricWeb& web);

  // Returns the unit direction in the luminaire's frame for u in [0,1)^2 (1 is taken as the limit).
  // u[0] chooses C (piecewise quadratic marginal), u[1] chooses gamma (linear x sine segments,
  // inverted by safeguarded Newton). The density of a sample is positive, except that u0 or u1 = 0
  // may give the dark edge at which the light begins.
  std::array<double, 3> sample(double u0, double u1) const;

  // Return the table and its sums, to sample elsewhere: [plane][gamma], integrals of I sin(gamma)
  // from the first angle; [plane], integrals over C of the plane totals (axial: {0, flux}), which
  // end at web.flux_lm() up to rounding.
  const PhotometricWeb& web() const { return web_; }
  const std::vector<double>& gamma_prefix() const { return gamma_prefix_; }
  const std::vector<double>& c_prefix() const { return c_prefix_; }

 private:
  // A plane between table planes, where the conditional distribution of gamma is taken.
  struct Plane {
    std::size_t below, above;  // table planes
    double fraction;           // of the way from below to above
  };
  double prefix(const Plane& plane, std::size_t gamma) const;
  double plane_total(std::size_t plane) const;
  double sample_gamma_rad(const Plane& plane, double u) const;

  const PhotometricWeb& web_;
  // [plane][gamma]: integral of I sin(gamma) from the first angle
  std::vector<double> gamma_prefix_;
  // [plane]: integral over C of the plane totals; axial: {0, flux}
  std::vector<double> c_prefix_;
};

}  // namespace calc
