#pragma once
// Installed power of a room in relation to its light.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <optional>
#include <string>

namespace report {

// Power in W/m² of the floor for each 100 lx of the average of `plane`.
struct PowerByLight {
  const PlanePart* plane = nullptr;
  calc::Estimate w_m2;
};

// Returns the value for the largest plane that faces up, preferring planes with a required average
// in normal operation, then planes with any requirement; the first of equal ones. Empty: power or
// area is not known, or no such plane has light.
std::optional<PowerByLight> power_by_light(const SpacePart& space);
// Returns "Desk"; if the plane is shown in another light, also the light of the average.
std::string power_plane_words(const Texts& t, const SpacePart& space, const PowerByLight& by_light);

}  // namespace report
