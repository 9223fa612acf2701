#include "calc/photometry/sine_segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace calc {
namespace {

// Integral of t sin(t) over [0, x], x in [0, pi]: sin(x) - x cos(x). Both terms are x for small x
// and the result x^3 / 3, hence this series for x <= 1.
constexpr std::size_t kTerms = 11;

// (-1)^k (2k + 2) / (2k + 3)!
constexpr std::array<double, kTerms> series_of_t_sin_t() {
  std::array<double, kTerms> coefficient{};
  double factorial = 6.0;  // (2k + 3)!
  double sign = 1.0;
  for (std::size_t k = 0; k < kTerms; ++k) {
    const double n = 2.0 * static_cast<double>(k);
    coefficient[k] = sign * (n + 2.0) / factorial;
    factorial *= (n + 4.0) * (n + 5.0);
    sign = -sign;
  }
  return coefficient;
}

double small_integral_of_t_sin_t(double x) {
  static constexpr std::array<double, kTerms> kSeries = series_of_t_sin_t();
  const double square = x * x;
  double sum = kSeries[kTerms - 1];
  for (std::size_t k = kTerms - 1; k-- > 0;) sum = sum * square + kSeries[k];
  return x * square * sum;
}

// A segment with the sines that every step of an inversion needs.
class SegmentIntegral {
 public:
  explicit SegmentIntegral(const SineSegment& segment)
      : start_cd_(segment.start_cd),
        slope_((segment.end_cd - segment.start_cd) / segment.width_rad),
        sin_gamma_(std::sin(segment.gamma_rad)),
        cos_gamma_(std::cos(segment.gamma_rad)) {}

  struct Value {
    double integral, density;
  };
  Value at(double x_rad) const {
    const double sin_half = std::sin(0.5 * x_rad);
    const double cos_half = std::cos(0.5 * x_rad);
    const double sin_x = 2.0 * sin_half * cos_half;
    const double versine = 2.0 * sin_half * sin_half;  // 1 - cos x
    // sin(gamma + x/2) by the addition theorem: adding the angles first would lose digits next to
    // pi.
    const double sin_middle = sin_gamma_ * cos_half + cos_gamma_ * sin_half;
    const double flat = 2.0 * sin_half * sin_middle;  // integral of sin(gamma + t)
    const double t_sin_t =
        x_rad > 1.0 ? sin_x - x_rad * (1.0 - versine) : small_integral_of_t_sin_t(x_rad);
    // integral of t sin(gamma + t)
    const double ramp = sin_gamma_ * (x_rad * sin_x - versine) + cos_gamma_ * t_sin_t;
    return {std::max(0.0, start_cd_ * flat + slope_ * ramp),
            (start_cd_ + slope_ * x_rad) * (sin_gamma_ * (1.0 - versine) + cos_gamma_ * sin_x)};
  }

 private:
  double start_cd_, slope_, sin_gamma_, cos_gamma_;
};

}  // namespace

double integral_to(const SineSegment& segment, double x_rad) {
  return SegmentIntegral(segment).at(x_rad).integral;
}

double integral(const SineSegment& segment) { return integral_to(segment, segment.width_rad); }

double invert_integral(const SineSegment& segment, double target) {
  const SegmentIntegral integral(segment);
  const SegmentIntegral::Value end = integral.at(segment.width_rad);
  if (!(target > 0.0)) return 0.0;
  if (target >= end.integral) return segment.width_rad;
  double low = 0.0;
  double high = segment.width_rad;
  double x = high * invert_linear_density(std::max(0.0, integral.at(0.0).density),
                                          std::max(0.0, end.density), target / end.integral);
  constexpr double kSettled = 2.0 * std::numeric_limits<double>::epsilon();
  for (int step = 0; step < 100; ++step) {
    const SegmentIntegral::Value value = integral.at(x);
    const double excess = value.integral - target;
    if (excess == 0.0) break;
    (excess < 0.0 ? low : high) = x;
    double next = x - excess / value.density;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool settled = std::abs(next - x) <= kSettled * x;
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
