#pragma once
// A requirement with what was measured and what that comes to: plain data.

#include "calc/base/field.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/requirement.h"

#include <glm/glm.hpp>

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
  double margin = 0.0;  // (measured - limit) / limit, sign turned for at_most: > 0 is good
  bool is_close =
      false;  // usual rounding (whole lx, two digits of a ratio) would change the verdict
  bool is_waived = false;       // see waiver.h: it does not count, whatever the verdict
  bool is_doubtful = false;     // its interval cannot be trusted, see `reason`
  bool by_tolerance = false;    // passes only with the tolerance of the policy
  std::size_t points_used = 0;  // that the requirement's mask leaves; 0 when not judged
  std::optional<glm::dvec3>
      place_m;  // of the minimum (of uniformities, too), the maximum or the value
  // For undecided and not_judged, in words; of others that there is nothing to be rated, or the
  // doubt about other points of what one point is enough to fail.
  std::string reason;
  // `measured` without each replicate in turn, see rules/measure/leave_one_out.h; empty: not known.
  std::vector<double> without_replicate = {};
};

}  // namespace rules
