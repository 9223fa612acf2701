#pragma once
// Installed power of a room against the light that it gives.

#include "report/document/document.h"

#include <optional>

namespace report {

// W/m² of the floor for each 100 lx of the average of `plane`.
struct PowerByLight {
  const PlanePart* plane = nullptr;
  calc::Estimate w_m2;
};

// Of the largest plane that is looked at from above, among those that something is asked of if
// there are any. Empty: power or area are not known, or no such plane has light.
std::optional<PowerByLight> power_by_light(const SpacePart& space);

}  // namespace report
