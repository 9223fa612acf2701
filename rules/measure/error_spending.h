#pragma once
// The share of the allowed error that each sampling round of growing results uses.

#include "calc/base/field.h"

namespace rules {

// Returns the share of a plane's risk that sampling round `look` (0: the first) of up to `planned`
// (> look, fixed before the first) may use. The first uses a quarter, because most planes finish
// after it; the others share the rest equally. All shares add up to 1, and none is larger than the
// one before, so a limit of a point omitted after an earlier round still holds. [half for the
// first: no less time on 13 projects, a fifth more samples for close verdicts; shares that halve
// each round: 40 % more time]
constexpr double risk_share(int look, int planned) {
  if (planned < 2) return 1.0;
  const double first = planned > 4 ? 0.25 : 1.0 / planned;
  return look == 0 ? first : (1.0 - first) / (planned - 1);
}

// Returns the level of the intervals of one sampling round, so that all rounds together hold at
// `confidence` in (0, 1): at most, probabilities of error add up. A plane's last intervals,
// verdicts and printed values have this level.  [METHOD, 7.9; Bonferroni's inequality: Miller81]
constexpr double look_confidence(double confidence, int look, int planned) {
  return 1.0 - (1.0 - confidence) * risk_share(look, planned);
}

// Returns the level of the field's last sampling round.
inline double look_confidence(double confidence, const calc::PlaneField& field) {
  return look_confidence(confidence, field.last_look(), field.looks_planned);
}

}  // namespace rules
