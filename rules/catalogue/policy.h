#pragma once
// How numbers are compared with limits, as data: part of every rule pack. compare.h applies it.

#include "calc/base/names.h"
#include "rules/catalogue/unit.h"

#include <string>

namespace rules {

enum class Rounding { half_up, half_even, down };

// The default is strict: unrounded numbers, no tolerance.
struct DecisionPolicy {
  bool compares_rounded = false;  // the value is rounded as it is printed before it is compared
  Rounding rounding = Rounding::half_up;
  // Digits usually printed after the point; small values have more, for two significant digits.
  int illuminance_digits = 0;
  int ratio_digits = 2;
  int other_digits = 1;
  // A value may miss its limit by this share of the limit; the reason is then stated.
  double tolerance = 0.0;
  std::string tolerance_reason;
  // Relative expanded uncertainty that widens the interval on both sides.
  double guard = 0.0;

  // Returns the digits after the point. is_ratio: of two values of one plane.
  int digits(Dimension dimension, bool is_ratio) const {
    if (is_ratio) return ratio_digits;
    return dimension == Dimension::illuminance ? illuminance_digits : other_digits;
  }
  bool is_default() const;
};

// Returns one line for reports: "unrounded values, no tolerance".
std::string policy_text(const DecisionPolicy& policy);

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::Rounding> {
  static constexpr EnumName<rules::Rounding> list[] = {{rules::Rounding::half_up, "half-up"},
                                                       {rules::Rounding::half_even, "half-even"},
                                                       {rules::Rounding::down, "down"}};
};

}  // namespace calc
