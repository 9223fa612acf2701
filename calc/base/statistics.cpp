#include "calc/base/statistics.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace calc {
namespace {

// Gamma((v + 1) / 2) / (sqrt(pi) Gamma(v / 2)), the inverse of the beta function B(v / 2, 1 / 2),
// by its recurrence in steps of 2. Own code because std::lgamma writes a global variable.
double inverse_beta_half(int v) {
  if (v >
      1000) {  // asymptotic series of the ratio of gamma functions; the next term is below 1e-17
    const double u = 1.0 / v;
    const double series =
        1.0 - u / 4.0 + u * u / 32.0 + 5.0 * u * u * u / 128.0 - 21.0 * u * u * u * u / 2048.0;
    return std::sqrt(v / (2.0 * kPi)) * series;
  }
  double value = v % 2 == 1 ? 1.0 / kPi : 0.5;  // v = 1, v = 2
  for (int k = v % 2 == 1 ? 1 : 2; k < v; k += 2) value *= (k + 1.0) / k;
  return value;
}

// Continued fraction of the incomplete beta function: I_x(a, b) = x^a (1 - x)^b / (a B(a, b)) times
// this. [DLMF, 8.17.22], evaluated by the modified Lentz method; converges fast for x < (a + 1) /
// (a + b + 2).
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;  // stands in for a zero denominator
  const auto safe = [](double y) { return std::abs(y) < kTiny ? kTiny : y; };
  double c = 1.0;
  double d = 1.0 / safe(1.0 - (a + b) * x / (a + 1.0));
  double value = d;
  for (int m = 1; m <= 200000; ++m) {  // O(sqrt(max(a, b))) terms are needed
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    d = 1.0 / safe(1.0 + even * d);
    c = safe(1.0 + even / c);
    value *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    d = 1.0 / safe(1.0 + odd * d);
    c = safe(1.0 + odd / c);
    value *= d * c;
    if (std::abs(d * c - 1.0) < std::numeric_limits<double>::epsilon()) break;
  }
  return value;
}

// Student's t with v degrees of freedom, for t > 0. Both probabilities keep their relative
// accuracy.
class StudentT {
 public:
  explicit StudentT(int v) : v_(v), inverse_beta_(inverse_beta_half(v)) {}

  double density(double t) const {
    return inverse_beta_ / std::sqrt(v_) * calc::exp(-0.5 * (v_ + 1.0) * calc::log1p(t * t / v_));
  }
  double beyond(double t) const {  // P(T > t)
    return tail_converges(t) ? tail_by_fraction(t) : 0.5 * (1.0 - centre_by_fraction(t));
  }
  double within(double t) const {  // P(-t < T < t)
    return tail_converges(t) ? 1.0 - 2.0 * tail_by_fraction(t) : centre_by_fraction(t);
  }

 private:
  bool tail_converges(double t) const { return t * t * (v_ + 2.0) > 3.0 * v_; }

  // x^(v/2) (1 - x)^(1/2) / B with x = v / (v + t^2)
  double prefactor(double t) const {
    return inverse_beta_ * calc::exp(-0.5 * v_ * calc::log1p(t * t / v_)) * t /
           std::sqrt(v_ + t * t);
  }
  double tail_by_fraction(double t) const {  // half of I_x(v/2, 1/2)
    return 0.5 * prefactor(t) * beta_fraction(0.5 * v_, 0.5, v_ / (v_ + t * t)) / (0.5 * v_);
  }
  double centre_by_fraction(double t) const {  // I_(1-x)(1/2, v/2)
    return prefactor(t) * beta_fraction(0.5, 0.5 * v_, t * t / (v_ + t * t)) / 0.5;
  }

  double v_;
  double inverse_beta_;
};

// t > 0 with P(T > t) = tail, 0 < tail < 1/2: Newton's method kept inside a bracket by bisection.
// Near the centre the equation is solved for P(|T| < t) and beyond for log P(T > t), so that no
// digits cancel.
double upper_quantile(const StudentT& student, double tail) {
  const bool is_central = tail > 0.25;
  const double centre = 1.0 - 2.0 * tail;
  const auto excess = [&](double t) {  // increases with t
    return is_central ? student.within(t) - centre : calc::log(tail) - calc::log(student.beyond(t));
  };
  const auto slope = [&](double t) {
    return is_central ? 2.0 * student.density(t) : student.density(t) / student.beyond(t);
  };
  double low = 0.0;
  double high = 1.0;
  while (excess(high) < 0.0) {
    low = high;
    high *= 2.0;
  }
  double t = 0.5 * (low + high);
  for (int step = 0; step < 200; ++step) {
    const double f = excess(t);
    (f > 0.0 ? high : low) = t;
    double next = t - f / slope(t);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - t);
    t = next;
    if (change <= 2.0 * std::numeric_limits<double>::epsilon() * t) break;
  }
  return t;
}

}  // namespace

double student_t_quantile(double probability, int degrees_of_freedom) {
  if (probability == 0.5) return 0.0;
  const StudentT student(degrees_of_freedom);
  return probability > 0.5 ? upper_quantile(student, 1.0 - probability)
                           : -upper_quantile(student, probability);
}

ReplicateMean replicate_mean(std::span<const double> replicates) {
  // Sums of differences to the first value: equal replicates give that value and no error at all.
  const double first = replicates.front();
  const double count = static_cast<double>(replicates.size());
  double sum = 0.0;
  for (const double value : replicates) sum += value - first;
  ReplicateMean result{first + sum / count, 0.0};
  if (replicates.size() == 1) return result;
  double squares = 0.0;
  for (const double value : replicates) squares += (value - result.mean) * (value - result.mean);
  result.standard_error = std::sqrt(squares / (count - 1.0) / count);
  return result;
}

Estimate t_interval(std::span<const double> replicates, double confidence) {
  const ReplicateMean mean = replicate_mean(replicates);
  if (mean.standard_error == 0.0) return Estimate{mean.mean, mean.mean, mean.mean};
  const double t =
      student_t_quantile(0.5 + 0.5 * confidence, static_cast<int>(replicates.size()) - 1);
  const double half_width = t * mean.standard_error;
  return Estimate{mean.mean, mean.mean - half_width, mean.mean + half_width};
}

}  // namespace calc
