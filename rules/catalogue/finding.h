#pragma once
// A requirement with its measured value and its verdict: plain data.

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
  // (measured - limit) / limit, with the sign turned for at_most: > 0 is good. NaN if there is
  // none, see margin_of(); meaningless when not_judged.
  double margin = 0.0;
  // The usual rounding (whole lx, two digits of a ratio or a small value) would change the verdict.
  bool is_close = false;
  bool is_waived = false;       // see waiver.h: it does not count, whatever the verdict
  bool is_doubtful = false;     // its interval cannot be trusted, see `reason`
  bool by_tolerance = false;    // passes only with the tolerance of the policy
  std::size_t points_used = 0;  // that the requirement's mask leaves; 0 when not judged
  std::optional<glm::dvec3>
      place_m;  // of the minimum (of uniformities, too), the maximum or the value
  // The reason in words for undecided and not_judged. For others: nothing can be rated, or other
  // points are in doubt while a single point already fails.
  calc::Message reason;
  // `measured` without each replicate in turn, see rules/measure/leave_one_out.h; empty: not known.
  std::vector<double> without_replicate = {};
};

// Returns the margin for sorted lists; `none` if there is no margin.
inline double margin_or(const Finding& finding, double none) {
  return std::isnan(finding.margin) ? none : finding.margin;
}

}  // namespace rules
