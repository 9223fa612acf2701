#pragma once
// Installed power of a room against the light that it gives.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <optional>
#include <string>

namespace report {

// W/m² of the floor for each 100 lx of the average of `plane`.
struct PowerByLight {
  const PlanePart* plane = nullptr;
  calc::Estimate w_m2;
};

// Of the largest plane that faces up, among those of which an average is asked in normal operation
// if there are any, else of which anything is asked; the first of equal ones. Empty: power or area
// are not known, or no such plane has light.
std::optional<PowerByLight> power_by_light(const SpacePart& space);
// "Desk"; of a plane that is shown in another light also of which the average is.
std::string power_plane_words(const Texts& t, const SpacePart& space, const PowerByLight& by_light);

}  // namespace report
