#pragma once
// Plane outlines of IFC: profiles of extrusions, and their curves.

#include "calc/project/reading/project_elements.h"
#include "report/tools/import/design.h"
#include "report/tools/import/ifc_file.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace cli {

inline constexpr double kOutlineGap_m = 1.0e-3;  // ends of curves that are nearer meet
inline constexpr double kSamePoint_m = 1.0e-6;   // corners that are nearer are one
// Most corners of an outline in a project.
inline constexpr std::size_t kMostCorners = calc::kCornerLimit;

// Metres, in the profile's own plane. Corners in any direction, the first one not repeated; an
// outline may cross itself.
struct IfcProfile {
  std::vector<glm::dvec2> outer;
  std::vector<std::vector<glm::dvec2>> inner;
};

// Returns the profile. Throws IfcLeftOut. doubt: changes to it that the file does not state.
IfcProfile ifc_profile(IfcFile& file, const StepValue& reference, std::vector<std::string>& doubt);

// Removes corners at the place of the corner before them, the end included.
void drop_same_points(std::vector<glm::dvec2>& outline);

}  // namespace cli
