#include "rules/compare.h"

#include <cmath>

namespace rules {
namespace {

constexpr double kBinaryNoise =
    1e-9;  // relative; far above rounding in sums of 1e5 points, far below any meaning

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
  return comparison == Comparison::at_least ? value >= limit - noise : value <= limit + noise;
}

Verdict compare(const calc::Estimate& estimate, Comparison comparison, double limit) {
  const bool low_meets = meets(estimate.low, comparison, limit);
  const bool high_meets = meets(estimate.high, comparison, limit);
  if (low_meets && high_meets) return Verdict::pass;
  if (!low_meets && !high_meets) return Verdict::fail;
  return Verdict::undecided;
}

double margin(double value, Comparison comparison, double limit) {
  if (limit == 0.0) return 0.0;
  const double above = (value - limit) / limit;
  return comparison == Comparison::at_least ? above : -above;
}

double round_as_printed(double value, Metric metric) {
  const double scale = is_ratio(metric) ? 100.0 : 1.0;
  return std::floor(value * scale * (1.0 + kBinaryNoise) + 0.5) /
         scale;  // 0.595 is a bit less in binary
}

bool is_close_call(double value, Metric metric, Comparison comparison, double limit) {
  return meets(round_as_printed(value, metric), comparison, limit) !=
         meets(value, comparison, limit);
}

}  // namespace rules
