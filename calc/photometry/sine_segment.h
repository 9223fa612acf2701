#pragma once
// A piece of a plane between two table angles: intensity linear in gamma, weighted with sin(gamma).
// Closed forms of its integral and the inverse; flux and sampling both use them, so that they
// agree.

namespace calc {

// Requires 0 <= gamma_rad, width_rad > 0, gamma_rad + width_rad <= pi, and start_cd, end_cd >= 0.
struct SineSegment {
  double gamma_rad;  // lower angle
  double width_rad;
  double start_cd, end_cd;
};

// Returns the integral over the first x_rad (in [0, width_rad]) of intensity * sin(gamma) (cd rad).
// Its relative error is a few roundings, also for tiny segments and next to the poles.
double integral_to(const SineSegment& segment, double x_rad);
// Returns the same over the whole segment.
double integral(const SineSegment& segment);

// Returns the x_rad in [0, width_rad] with integral_to(segment, x_rad) == target, for target in [0,
// integral(segment)]; outside of it the nearer end. Newton steps kept inside a shrinking bracket.
double invert_integral(const SineSegment& segment, double target);

// Returns the s in [0, 1] below which the share u in [0, 1] lies of a density linear from `start`
// to `end` (both >= 0); u itself if both are 0.
double invert_linear_density(double start, double end, double u);

}  // namespace calc
