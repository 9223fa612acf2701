#include "rules/catalogue/compare.h"

#include "calc/base/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rules {
namespace {

constexpr double kBinaryNoise =
    1e-9;  // relative; far above rounding in sums of 1e5 points, far below any meaning

double loosened(double limit, Comparison comparison, double tolerance) {
  return limit * (is_lower_limit(comparison) ? 1.0 - tolerance : 1.0 + tolerance);
}

// Returns the value as printed: reports show two significant digits of small values, so 0.6 lx is
// not 1 lx.
double as_printed(double value, int digits, Rounding rounding) {
  constexpr int kSignificant = 2, kMostDigits = 9;
  if (value == 0.0 || !std::isfinite(value)) return value;
  const int first = static_cast<int>(std::floor(calc::log10(std::abs(value))));
  const int of_small = std::min(kSignificant - 1 - first, kMostDigits);
  return round_to(value, std::max(digits, of_small), rounding);
}

// Compares the ends one by one after rounding, which keeps the order of numbers.
Verdict compare(const Comparand& comparand, const DecisionPolicy& policy, double tolerance) {
  const auto is_met = [&](double value, double limit) {
    const double compared =
        policy.compares_rounded ? as_printed(value, comparand.digits, policy.rounding) : value;
    return meets(compared, comparand.comparison, loosened(limit, comparand.comparison, tolerance));
  };
  // An end that is open stays so, with a guard of 0, too.
  const auto guard = [&](double value) {
    return std::isfinite(value) ? policy.guard * std::abs(value) : 0.0;
  };
  int met = 0;
  const calc::Estimate& measured = comparand.measured;
  for (const double value :
       {measured.low - guard(measured.low), measured.high + guard(measured.high)}) {
    for (const double limit : {comparand.limit.low, comparand.limit.high}) {
      if (is_met(value, limit)) ++met;
    }
  }
  return met == 4 ? Verdict::pass : (met == 0 ? Verdict::fail : Verdict::undecided);
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::undecided:
      return "undecided";
    case Verdict::not_judged:
      break;
  }
  return "not judged";
}

bool meets(double value, Comparison comparison, double limit) {
  const double noise = kBinaryNoise * std::abs(limit);
  switch (comparison) {
    case Comparison::at_least:
      return value >= limit - noise;
    case Comparison::at_most:
      return value <= limit + noise;
    case Comparison::more_than:
      return value > limit + noise;
    case Comparison::less_than:
      return value < limit - noise;
  }
  return false;
}

Decision decide(const Comparand& comparand, const DecisionPolicy& policy) {
  Decision decision;
  decision.verdict = compare(comparand, policy, policy.tolerance);
  decision.by_tolerance = policy.tolerance > 0.0 && decision.verdict == Verdict::pass &&
                          compare(comparand, policy, 0.0) != Verdict::pass;
  const double value = comparand.measured.value;
  const double limit = loosened(comparand.limit.value, comparand.comparison, policy.tolerance);
  const double printed = as_printed(value, comparand.digits, policy.rounding);
  decision.is_close =
      meets(printed, comparand.comparison, limit) != meets(value, comparand.comparison, limit);
  return decision;
}

double margin(double value, Comparison comparison, double limit) {
  if (limit == 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double above = (value - limit) / limit;
  return is_lower_limit(comparison) ? above : -above;
}

double margin(const calc::Estimate& measured, Comparison comparison, double limit) {
  double known = measured.value;
  if (std::isfinite(known)) {
    if (!std::isfinite(measured.low) && std::isfinite(measured.high)) known = measured.high;
    if (!std::isfinite(measured.high) && std::isfinite(measured.low)) known = measured.low;
  }
  return margin(known, comparison, limit);
}

double round_to(double value, int digits, Rounding rounding) {
  if (!std::isfinite(value)) return value;
  const double scale = calc::pow(10.0, digits);
  const double scaled = value * scale;
  const double exact = scaled * (1.0 + kBinaryNoise);
  switch (rounding) {
    case Rounding::down:
      return std::floor(exact) / scale;
    case Rounding::half_even:
      // A tie, give or take binary noise, goes to the even neighbour.
      if (std::abs(scaled - std::floor(scaled) - 0.5) <= kBinaryNoise * std::abs(scaled)) {
        const double below = std::floor(scaled);
        return (std::fmod(below, 2.0) == 0.0 ? below : below + 1.0) / scale;
      }
      return std::floor(scaled + 0.5) / scale;
    case Rounding::half_up:
      break;
  }
  return std::floor(exact + 0.5) / scale;
}

}  // namespace rules
