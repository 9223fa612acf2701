#pragma once
// A requirement with what was measured and what that comes to: plain data.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/requirement.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rules {

struct Finding {
  Requirement requirement;
  Verdict verdict = Verdict::not_judged;
  // Unit of the requirement; meaningless when not_judged. Ends may be open, see has_open_ends().
  calc::Estimate measured;
  // (measured - limit) / limit, sign turned for at_most: > 0 is good. Not a number where there is
  // none, see margin_of(); meaningless when not_judged.
  double margin = 0.0;
  // Usual rounding (whole lx, two digits of a ratio or of what is small) would change the verdict.
  bool is_close = false;
  bool is_waived = false;       // see waiver.h: it does not count, whatever the verdict
  bool is_doubtful = false;     // its interval cannot be trusted, see `reason`
  bool by_tolerance = false;    // passes only with the tolerance of the policy
  std::size_t points_used = 0;  // that the requirement's mask leaves; 0 when not judged
  std::optional<glm::dvec3>
      place_m;  // of the minimum (of uniformities, too), the maximum or the value
  // For undecided and not_judged, in words; of others that there is nothing to be rated, or the
  // doubt about other points of what one point is enough to fail.
  calc::Message reason;
  // `measured` without each replicate in turn, see rules/measure/leave_one_out.h; empty: not known.
  std::vector<double> without_replicate = {};
};

// For lists in the order of margins: what has none has `none`.
inline double margin_or(const Finding& finding, double none) {
  return std::isnan(finding.margin) ? none : finding.margin;
}

}  // namespace rules
