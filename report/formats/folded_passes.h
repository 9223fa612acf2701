#pragma once
// Folds many passing requirements of workplaces into one line, because in a wall of good numbers
// nobody finds the bad one.

#include "report/document/document.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Planes of a space that share a line, of one workplace or (several = true) of several.
struct FoldedPasses {
  std::vector<const PlanePart*> planes;  // in the order of the report
  bool of_several = false;
  std::size_t requirements() const;  // without advice
  // Returns the finding with the least margin, among those that count if there are any, and its
  // plane.
  const rules::Finding& nearest() const;
  const PlanePart& plane_of_nearest() const;
};

// Returns groups of planes made by workplaces whose requirements all pass without anything to
// decide: no deviation, waiver, change or doubt about the light, and not close to the limit. A
// single plane is not folded.
std::vector<FoldedPasses> folded_passes(const SpacePart& space);

}  // namespace report
