// A piece of a photometric plane between two table angles, intensity linear in gamma, weighted with
// sin(gamma): one text for C++ (sine_segment.cpp) and GLSL (gpu/). What it may use beside the words
// of calc/base/shader_words.h: SineCosine half_angle(x), of x / 2, and abs, min, max, clamp, sqrt.

// Intensity at the lower angle, its slope per rad, and the lower angle.
struct SegmentShape {
  double start_cd, slope, sin_gamma, cos_gamma;
};

struct SegmentValue {
  double integral, density;
};

// Integral of t sin(t) over [0, x]: sin(x) - x cos(x). Both terms are x for small x and the result
// x^3 / 3, hence this series for x <= 1: (-1)^k (2k + 2) / (2k + 3)! x^(2k + 3).
TERM double small_integral_of_t_sin_t(double x) {
  const double square = x * x;
  double sum = DBL(22.0) / DBL(25852016738884976640000.0);
  sum = sum * square - DBL(20.0) / DBL(51090942171709440000.0);
  sum = sum * square + DBL(18.0) / DBL(121645100408832000.0);
  sum = sum * square - DBL(16.0) / DBL(355687428096000.0);
  sum = sum * square + DBL(14.0) / DBL(1307674368000.0);
  sum = sum * square - DBL(12.0) / DBL(6227020800.0);
  sum = sum * square + DBL(10.0) / DBL(39916800.0);
  sum = sum * square - DBL(8.0) / DBL(362880.0);
  sum = sum * square + DBL(6.0) / DBL(5040.0);
  sum = sum * square - DBL(4.0) / DBL(120.0);
  sum = sum * square + DBL(2.0) / DBL(6.0);
  return x * square * sum;
}

TERM SegmentValue segment_at(SegmentShape segment, double x_rad) {
  const SineCosine half_x = half_angle(x_rad);
  const double sin_x = DBL(2.0) * half_x.sine * half_x.cosine;
  const double versine = DBL(2.0) * half_x.sine * half_x.sine;  // 1 - cos x
  // sin(gamma + x/2) by the addition theorem: adding the angles first would lose digits next to pi.
  const double sin_middle = segment.sin_gamma * half_x.cosine + segment.cos_gamma * half_x.sine;
  const double even = DBL(2.0) * half_x.sine * sin_middle;  // integral of sin(gamma + t)
  const double t_sin_t = x_rad > DBL(1.0) ? sin_x - x_rad * (DBL(1.0) - versine)
                                          : small_integral_of_t_sin_t(x_rad);
  // integral of t sin(gamma + t)
  const double ramp =
      segment.sin_gamma * (x_rad * sin_x - versine) + segment.cos_gamma * t_sin_t;
  SegmentValue value;
  value.integral = max(DBL(0.0), segment.start_cd * even + segment.slope * ramp);
  value.density = (segment.start_cd + segment.slope * x_rad) *
                  (segment.sin_gamma * (DBL(1.0) - versine) + segment.cos_gamma * sin_x);
  return value;
}

TERM double share_of_linear_density(double start, double end, double u) {
  // Root of start s + (end - start) s^2 / 2 = u (start + end) / 2, in the form without
  // cancellation.
  const double divisor = start + sqrt(start * start * (DBL(1.0) - u) + end * end * u);
  if (!(divisor > DBL(0.0))) return u;
  return min(DBL(1.0), u * (start + end) / divisor);
}

// The x in [0, width_rad] at which the integral reaches target.
TERM double invert_segment(SegmentShape segment, double width_rad, double target) {
  const SegmentValue whole = segment_at(segment, width_rad);
  if (!(target > DBL(0.0))) return DBL(0.0);
  if (target >= whole.integral) return width_rad;
  double low = DBL(0.0);
  double high = width_rad;
  double x = high * share_of_linear_density(
                        max(DBL(0.0), segment_at(segment, DBL(0.0)).density),
                        max(DBL(0.0), whole.density), target / whole.integral);
  const double settled = DBL(4.440892098500626e-16);  // two roundings
  for (int step = 0; step < 100; ++step) {
    const SegmentValue value = segment_at(segment, x);
    const double excess = value.integral - target;
    if (excess == DBL(0.0)) break;
    if (excess < DBL(0.0)) {
      low = x;
    } else {
      high = x;
    }
    double next = x - excess / value.density;
    if (!(next > low && next < high)) next = DBL(0.5) * (low + high);
    const bool is_settled = abs(next - x) <= settled * x;
    x = next;
    if (is_settled) break;
  }
  return clamp(x, DBL(0.0), width_rad);
}
