#pragma once
// A plane as people are shown it.

#include "report/document/document.h"

#include <optional>

namespace report {

// In the light that its requirements ask for, where they ask for one alone: points and statistics
// are of it, and the others wait in asked_light. All else is as in the document.
class ShownPlane {
 public:
  // plane: outlives this.
  explicit ShownPlane(const PlanePart& plane);

  const PlanePart& operator*() const { return changed_ ? *changed_ : plane_; }

 private:
  const PlanePart& plane_;
  std::optional<PlanePart> changed_;
};

}  // namespace report
