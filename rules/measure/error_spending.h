#pragma once
// What every look at growing results costs in confidence.

#include "calc/base/field.h"

namespace rules {

// Share of the risk of a plane that look number `look` (0: the first) of up to `planned` (> look,
// fixed before the first) may spend: a quarter of it the first, after which most planes are
// finished, and the others the rest in equal parts. All shares add up to 1; none is larger than the
// one before, so that a limit of a point that was left out after an earlier look still holds.
// [half of it: no less time on 13 projects, and a fifth more samples for close verdicts; shares
// that halve from look to look: 40 % more time]
constexpr double risk_share(int look, int planned) {
  if (planned < 2) return 1.0;
  const double first = planned > 4 ? 0.25 : 1.0 / planned;
  return look == 0 ? first : (1.0 - first) / (planned - 1);
}

// Level of the intervals of one look, such that all looks together hold at `confidence` in (0, 1):
// probabilities of error add up at most. Whenever a plane stops, its last intervals, its verdicts
// and what is printed have this level.  [METHOD, 7.9; Bonferroni's inequality: Miller81]
constexpr double look_confidence(double confidence, int look, int planned) {
  return 1.0 - (1.0 - confidence) * risk_share(look, planned);
}

// Of the last look that the field has taken.
inline double look_confidence(double confidence, const calc::PlaneField& field) {
  return look_confidence(confidence, field.last_look(), field.looks_planned);
}

}  // namespace rules
