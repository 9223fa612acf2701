#pragma once
// A plane as reports show it.

#include "report/document/document.h"

#include <optional>

namespace report {

// If all requirements are for a single light, points and statistics are of that light, and the
// others are in asked_light. Everything else is as in the document.
class ShownPlane {
 public:
  // plane: must outlive this.
  explicit ShownPlane(const PlanePart& plane);

  const PlanePart& operator*() const { return changed_ ? *changed_ : plane_; }

 private:
  const PlanePart& plane_;
  std::optional<PlanePart> changed_;
};

}  // namespace report
