#pragma once
// Where IFC things are: axis placements, chains of local placements, operators of mapped items.

#include "report/tools/import/ifc_file.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <unordered_map>

namespace cli {

inline constexpr int kLongestPlacementChain = 100;

// The placed frame in its parent's, in metres, columns x, y, z, origin. Of IFCAXIS2PLACEMENT3D or
// IFCAXIS2PLACEMENT2D; null: no change. Throws IfcLeftOut.
glm::dmat4 ifc_axis_placement(IfcFile& file, const StepValue& reference);
// Of IFCCARTESIANTRANSFORMATIONOPERATOR3D and ...NONUNIFORM: may scale and mirror.
glm::dmat4 ifc_operator(IfcFile& file, const StepValue& reference);

// Frames of products in the world. Each placement is read once.
class IfcPlacements {
 public:
  explicit IfcPlacements(IfcFile& file) : file_(file) {}
  // Of IFCLOCALPLACEMENT. Throws IfcLeftOut: none, another kind, a chain that is longer than
  // kLongestPlacementChain or a circle.
  glm::dmat4 world_from(const StepValue& reference);

 private:
  IfcFile& file_;
  std::unordered_map<std::uint32_t, glm::dmat4> known_;
};

}  // namespace cli
