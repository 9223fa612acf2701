#include "calc/photometry/sine_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace calc {
namespace {

// Integral of t sin(t) over [0, x], x in [0, pi]: sin(x) - x cos(x). Both terms are x for small x
// and the result x^3 / 3, hence the series there.
double integral_of_t_sin_t(double x) {
  if (x > 1.0) return std::sin(x) - x * std::cos(x);
  const double square = x * x;
  double term = x * square / 3.0;  // (-1)^k (2k+2) / (2k+3)! x^(2k+3)
  double sum = term;
  for (int k = 0; k < 10; ++k) {
    const double n = 2.0 * k;
    term *= -square * (n + 4.0) / ((n + 2.0) * (n + 4.0) * (n + 5.0));
    sum += term;
  }
  return sum;
}

}  // namespace

double integral_to(const SineSegment& segment, double x_rad) {
  const double sin_gamma = std::sin(segment.gamma_rad);
  const double cos_gamma = std::cos(segment.gamma_rad);
  const double sin_half = std::sin(0.5 * x_rad);
  // sin(gamma + x/2) by the addition theorem: adding the angles first would lose digits next to pi.
  const double sin_middle = sin_gamma * std::cos(0.5 * x_rad) + cos_gamma * sin_half;
  const double flat = 2.0 * sin_half * sin_middle;  // integral of sin(gamma + t)
  const double ramp = sin_gamma * (x_rad * std::sin(x_rad) - 2.0 * sin_half * sin_half) +
                      cos_gamma * integral_of_t_sin_t(x_rad);  // integral of t sin(gamma + t)
  const double slope = (segment.end_cd - segment.start_cd) / segment.width_rad;
  return std::max(0.0, segment.start_cd * flat + slope * ramp);
}

double integral(const SineSegment& segment) { return integral_to(segment, segment.width_rad); }

double invert_integral(const SineSegment& segment, double target) {
  const double whole = integral(segment);
  if (!(target > 0.0)) return 0.0;
  if (target >= whole) return segment.width_rad;
  const double slope = (segment.end_cd - segment.start_cd) / segment.width_rad;
  const auto density = [&](double x) {
    return (segment.start_cd + slope * x) * std::sin(segment.gamma_rad + x);
  };
  double low = 0.0;
  double high = segment.width_rad;
  double x = high * invert_linear_density(std::max(0.0, density(low)), std::max(0.0, density(high)),
                                          target / whole);
  for (int step = 0; step < 100; ++step) {
    const double excess = integral_to(segment, x) - target;
    if (excess == 0.0) break;
    (excess < 0.0 ? low : high) = x;
    double next = x - excess / density(x);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool settled = std::abs(next - x) <= 2.0 * std::numeric_limits<double>::epsilon() * x;
    x = next;
    if (settled) break;
  }
  return std::clamp(x, 0.0, segment.width_rad);
}

double invert_linear_density(double start, double end, double u) {
  // Root of start s + (end - start) s^2 / 2 = u (start + end) / 2, in the form without
  // cancellation.
  const double divisor = start + std::sqrt(start * start * (1.0 - u) + end * end * u);
  if (!(divisor > 0.0)) return u;
  return std::min(1.0, u * (start + end) / divisor);
}

}  // namespace calc
