#pragma once
// Requirements of workplaces that pass, many in a line: of a wall of numbers in which everything is
// right nobody finds the one that is not.

#include "report/document/document.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Planes of a space, of one workplace or (several = true) of several that share them.
struct FoldedPasses {
  std::vector<const PlanePart*> planes;  // in the order of the report
  bool of_several = false;
  std::size_t requirements() const;  // without advice
  // Of the requirements that count, or else of all, the one with the least margin, and its plane.
  const rules::Finding& nearest() const;
  const PlanePart& plane_of_nearest() const;
};

// Only planes that a workplace has made, all requirements of which pass with nothing to decide
// about: no deviation, no waiver, nothing changed, no doubt about the light, not close to the
// limit. A plane for itself is not folded.
std::vector<FoldedPasses> folded_passes(const SpacePart& space);

}  // namespace report
