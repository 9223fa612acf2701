#pragma once
// What every look at growing results costs in confidence.

namespace rules {

// Level of each interval of a plane that is looked at up to `planned` times (>= 1, fixed before the
// first look), such that all its looks together hold at `confidence` in (0, 1): every look may be
// wrong with probability (1 - confidence) / planned, and probabilities of error add up at most.
// Whenever a plane stops, its last intervals, its verdicts and what is printed have this level.
// [METHOD, 7.9; Bonferroni's inequality: Miller81]
constexpr double look_confidence(double confidence, int planned) {
  return 1.0 - (1.0 - confidence) / planned;
}

}  // namespace rules
