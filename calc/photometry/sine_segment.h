#pragma once
// One piece of a plane between two table angles: intensity linear in gamma, weighted with
// sin(gamma). Closed forms of its integral and the inverse; flux and sampling both use them, so
// that they agree.

namespace calc {

// 0 <= gamma_rad, width_rad > 0, gamma_rad + width_rad <= pi; start_cd, end_cd >= 0.
struct SineSegment {
  double gamma_rad;  // lower angle
  double width_rad;
  double start_cd, end_cd;
};

// Integral over the first x_rad (in [0, width_rad]) of intensity * sin(gamma) (cd rad), relative
// error a few roundings also for tiny segments and next to the poles.
double integral_to(const SineSegment& segment, double x_rad);
// The same over the whole segment.
double integral(const SineSegment& segment);

// The x_rad in [0, width_rad] with integral_to(segment, x_rad) == target, for target in
// [0, integral(segment)]; outside of it the nearer end. Newton steps kept inside a shrinking
// bracket.
double invert_integral(const SineSegment& segment, double target);

// The s in [0, 1] at which the share u in [0, 1] of a density linear from `start` to `end` (both >=
// 0) lies below s; u itself if both are 0.
double invert_linear_density(double start, double end, double u);

}  // namespace calc
