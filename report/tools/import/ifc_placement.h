#pragma once
// Places of IFC things: axis placements, chains of local placements, operators of mapped items.

#include "report/tools/import/ifc_file.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <unordered_map>

namespace cli {

inline constexpr int kLongestPlacementChain = 100;

// Returns the placed frame in its parent's, in metres, columns x, y, z, origin, for
// IFCAXIS2PLACEMENT3D or IFCAXIS2PLACEMENT2D; null: no change. Throws IfcLeftOut.
glm::dmat4 ifc_axis_placement(IfcFile& file, const StepValue& reference);
// Returns the frame of IFCCARTESIANTRANSFORMATIONOPERATOR3D and ...NONUNIFORM, which may scale and
// mirror.
glm::dmat4 ifc_operator(IfcFile& file, const StepValue& reference);

// Frames of products in the world. Each placement is read once.
class IfcPlacements {
 public:
  explicit IfcPlacements(IfcFile& file) : file_(file) {}
  // Returns the frame of IFCLOCALPLACEMENT. Throws IfcLeftOut if there is none, it is another kind,
  // or the chain is a circle or longer than kLongestPlacementChain.
  glm::dmat4 world_from(const StepValue& reference);

 private:
  IfcFile& file_;
  std::unordered_map<std::uint32_t, glm::dmat4> known_;
};

}  // namespace cli
