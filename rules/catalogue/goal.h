#pragma once
// The goal of the calculation of a plane.

#include "calc/base/names.h"

namespace rules {

// verdict: every requirement passes or fails; the intervals may stay wide.
// accuracy: every judged quantity is known to a relative half-width.
enum class Goal { verdict, accuracy };

}  // namespace rules

namespace calc {

// Names on the command line and in reports.
template <>
struct EnumNames<rules::Goal> {
  static constexpr EnumName<rules::Goal> list[] = {{rules::Goal::verdict, "verdict"},
                                                   {rules::Goal::accuracy, "accuracy"}};
};

}  // namespace calc
