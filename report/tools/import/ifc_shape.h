#pragma once
// Bodies of IFC products: rooms as outlines with a height, furniture as boxes.

#include "report/tools/import/ifc_file.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// The shape of a room: metres, in the world.
struct IfcRoomShape {
  std::vector<glm::dvec2> outline;            // simple, counter-clockwise
  std::vector<std::vector<glm::dvec2>> hole;  // simple, clockwise, within the outline
  double floor_z_m = 0.0, height_m = 0.0;     // height > 0
  std::vector<std::string> doubt;             // clauses
};

// Returns the shape. representation: of the product, IFCPRODUCTDEFINITIONSHAPE. The body must be
// upright on one level floor that is as wide as itself. Throws IfcLeftOut.
IfcRoomShape ifc_room_shape(IfcFile& file, const StepValue& representation,
                            const glm::dmat4& world_from_product);

// The frame in which a product's type has its body: that of the mapped representation.
struct IfcTypeFrame {
  glm::dmat4 product_from_type{1.0};
  std::optional<std::uint32_t> map;  // IFCREPRESENTATIONMAP; empty: the product's own frame
};
// Returns the frame from the only mapped item of the body; the product's own frame if there is
// none, or several, or it cannot be read.
IfcTypeFrame ifc_type_frame(IfcFile& file, const StepValue& representation);

struct IfcExtent {
  glm::dvec3 low{0.0}, high{0.0};
  std::vector<std::string> doubt;
};
// Returns the extent of the whole body, in the frame of its type. Throws IfcLeftOut, also if any of
// its parts cannot be read.
IfcExtent ifc_extent(IfcFile& file, const StepValue& representation, const IfcTypeFrame& type);

}  // namespace cli
