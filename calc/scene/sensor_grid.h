#pragma once
// Calculation points of a plane, and an account of how they were chosen.

#include "calc/diagnostics.h"
#include "calc/scene/project.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace calc {

enum class DropReason { outside_area, within_margin, outside_room, inside_solid };

struct DroppedPoint {
  glm::dvec3 position_m;
  int column, row;
  DropReason reason;
  std::string body;  // id of the solid for inside_solid
};

// Points of one plane. Grid planes: point i sits in cell (column[i], row[i]) of columns x rows
// cells, u to the right and v up; point lists have columns = rows = 0 and no cells: column[i] is
// then the place in the list, row[i] 0.
struct SensorGrid {
  std::string rule;  // words: "EN 12464-1 (p = 0.2 * 5^log10 d)", "count", "spacing", "point list"
  int columns = 0, rows = 0;
  double spacing_u_m = 0.0, spacing_v_m = 0.0;  // cell size; 0 for point lists
  double margin_m = 0.0;
  glm::dvec3 origin_m{0.0}, u{1, 0, 0}, v{0, 1, 0};  // lower left corner of cell (0, 0) and axes
  std::vector<glm::dvec3> position_m;
  ReceiverKernel kernel = ReceiverKernel::planar;
  DerivedQuantity derived = DerivedQuantity::none;
  std::vector<glm::dvec3> normal;  // unit: the kernel's axis
  std::vector<int> column, row;
  std::vector<DroppedPoint> dropped;

  // The side of a surface that point i counts as, should it lie in one: that of the plane's own
  // normal, whatever the axis; a list has nothing but its normals. Unit.
  glm::dvec3 front(std::size_t i) const { return columns > 0 ? glm::cross(u, v) : normal[i]; }
};

// Cells along one side by the EN 12464-1 rule: p = 0.2 * 5^(log10 d) m, at most 10 m, d = the
// longer side, or the shorter one when longer / shorter >= 2; the count is side / p rounded to the
// nearest integer, at least 1. Sides in metres, > 0. (EN 12464-1:2021, 4.4; ties and the ratio 2
// are taken with a relative tolerance of 1e-9.)
struct GridCounts {
  int columns, rows;
};
GridCounts en12464_grid_counts(double side_u_m, double side_v_m);

// The points of `plane`, which must belong to `space`: centres of the cells of the outline's
// bounding rectangle less the margin, without those outside the outline, in a hole or on its edge,
// nearer to the outline than the margin (holes have none), outside the room (its surfaces count as
// inside), or inside a closed body. A planar point on the face of a closed body stays if it does
// not look into the body, one of any other kernel only if there is nothing but air in front of it,
// on the plane's side: half of it would lie in the body otherwise. Errors, with empty result: a
// margin that leaves nothing, more than 4 million points, no point left.
std::optional<SensorGrid> make_sensor_grid(const CalcPlane& plane, const Space& space,
                                           Diagnostics& diagnostics);

}  // namespace calc
