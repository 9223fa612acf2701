#include "report/revision/values.h"

#include "report/revision/matching.h"

#include <cstddef>
#include <utility>

namespace report {

std::optional<ChangedPlane> compare_values(const PlanePart& before, const PlanePart& after,
                                           const RevisionPlace& place) {
  if (!before.is_computed || !after.is_computed || before.points.size() != after.points.size() ||
      before.derived != after.derived || before.kernel != after.kernel ||
      calc::is_plain_number(after.derived)) {
    return std::nullopt;
  }
  ChangedPlane changed{place, {}};
  bool is_other = false;
  for (std::size_t k = 0; k < after.points.size(); ++k) {
    const PointRow &was = before.points[k], &is = after.points[k];
    if (!is_same_place(was.position_m, is.position_m)) return std::nullopt;
    is_other = is_other || was.measured.value != is.measured.value;
    changed.before_lx.push_back(was.measured.value);
  }
  if (!is_other) return std::nullopt;
  return changed;
}

}  // namespace report
