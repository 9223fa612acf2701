#pragma once
// Tests whether the cells of a grid leave a part of their area without a point.

#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <optional>

namespace calc {

// Returns why a point of the plane (along u and v) does not count; empty if it does. Points in a
// hole or on its edge are outside the area. The margin runs along the outline only.
std::optional<DropReason> reason_to_drop(const PlanarArea& area, glm::dvec2 point);

// Cells whose centres are candidates for points; lower_m: corner of the first, along u and v.
struct GridCells {
  glm::dvec2 lower_m, cell_m;
  int columns, rows;
};

struct MissedPart {
  double area_m2;
  glm::dvec2 at_m;  // one place in it, along u and v
};

// Returns the largest connected missed part of the counting area. It is missed if no straight way
// within the area, of at most one cell along u and along v, leads from it to a counting cell
// centre. Empty unless it is larger than a cell or than a twentieth of the area. Found by sampling,
// so that parts of less than an eighth of a cell may be overlooked.
std::optional<MissedPart> missed_part(const PlanarArea& area, const GridCells& cells);

}  // namespace calc
