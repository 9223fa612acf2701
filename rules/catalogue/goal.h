#pragma once
// What the calculation of a plane is done for.

namespace rules {

// verdict: every requirement passes or fails; the intervals may stay wide.
// accuracy: every judged quantity is known to a relative half-width.
enum class Goal { verdict, accuracy };

// "verdict" or "accuracy", as written on the command line and in reports.
constexpr const char* goal_name(Goal goal) {
  return goal == Goal::verdict ? "verdict" : "accuracy";
}

}  // namespace rules
