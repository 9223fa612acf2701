#pragma once
// The calculation points of a plane, and a record of how they were chosen.

#include "calc/base/diagnostics.h"
#include "calc/base/message.h"
#include "calc/scene/point_filter.h"
#include "calc/scene/project.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace calc {

struct DroppedPoint {
  glm::dvec3 position_m;
  int column, row;
  DropReason reason;
  std::string body;  // its id, for inside_solid, in_the_way and in_surface
};

// A point in a surface, measured on the side of it where there is air.
struct InnerPoint {
  std::size_t point;
  std::string body;
};

// The cells of an escape route, see RouteCells.
struct RouteGrid {
  RouteLine line;
  std::vector<int> stations;  // of each leg; all together the grid's columns
  double height_m = 0.0;      // of the points above the walking surface

  RouteCells cells(int rows) const { return {line, stations, rows}; }
};

// The points of one plane. Grid planes: point i is in cell (column[i], row[i]) of columns x rows
// cells, u to the right and v up; point lists have columns = rows = 0 and no cells: column[i] is
// then the place in the list, row[i] 0. For routes columns are stations along the line, rows go
// from its right side to its left one, and u and v are the world's x and y.
struct SensorGrid {
  // Words: "count", "spacing", "point list", or the whole derivation: see grid_words().
  Message rule;
  int columns = 0, rows = 0;
  // Cell size; 0 for point lists; for routes the largest one along, and across.
  double spacing_u_m = 0.0, spacing_v_m = 0.0;
  double margin_m = 0.0;
  glm::dvec3 origin_m{0.0}, u{1, 0, 0}, v{0, 1, 0};  // lower left corner of cell (0, 0) and axes
  std::vector<glm::dvec2> outline_m;  // of the plane's area, along u and v from origin_m
  std::vector<glm::dvec2> room_m;     // walls around it, world x and y; empty: none
  bool has_unknown_walls = false;     // in a room of a building file without outline
  std::optional<RouteGrid> route;
  std::vector<glm::dvec3> position_m;
  // The shifts to where points are measured, see PointStand: micrometres off the surface that
  // contains them. Empty: no point is shifted.
  std::vector<glm::dvec3> shift_m;
  std::vector<InnerPoint> inner;
  glm::dvec3 travel{0.0};  // as the plane's
  ReceiverKernel kernel = ReceiverKernel::planar;
  DerivedQuantity derived = DerivedQuantity::none;
  std::vector<glm::dvec3> normal;  // unit: the kernel's axis
  std::vector<int> column, row;
  std::vector<DroppedPoint> dropped;
  double missed_m2 = 0.0;  // of the area: the largest part that a given grid has no point for

  glm::dvec3 measured_m(std::size_t i) const {
    return shift_m.empty() ? position_m[i] : position_m[i] + shift_m[i];
  }
};

// Returns the weight of each point in averages: on a route the area of its cell, m2, because its
// cells differ at bends. Empty where all weights are equal.
std::vector<double> point_weights(const SensorGrid& grid);

// Cells along both sides by a rule; the number is side / p, rounded by the rule, at least 1 (EN
// 12464-1 rounds to the nearest; EN 12464-1:2021, 4.4). Sides in metres, > 0. Ties, whole numbers
// and the ratio of the sides are taken with a relative tolerance of 1e-9.
struct GridCounts {
  int columns, rows;
};
GridCounts grid_counts(const GridByRule& rule, double side_u_m, double side_v_m);

// Returns the text for a report: the rule, the side it used, the spacing, both quotients, the
// rounding and the counts.
Message grid_words(const GridByRule& rule, double side_u_m, double side_v_m);

// Returns the number of points of a plane's grid before any is dropped, as make_sensor_grid() makes
// it; any number for grids that it refuses. It makes no grid.
double planned_points(const CalcPlane& plane);
// Returns an upper bound of planned_points(), equal where the area is a rectangle or its cells are
// given. It is fast, where planned_points() may search the whole area.
double most_planned_points(const CalcPlane& plane);

// Returns the points of `plane`, which must belong to `space`: centres of the cells of the
// outline's bounding rectangle less the margin, without those outside the outline, in a hole or on
// its edge, nearer to the outline than the margin (holes have none), or where nothing can be
// measured (see PointFilter::stand()). A point in a surface counts as on the side of the plane's
// own normal, whatever its axis; a point of a list has only its normal. Errors, with empty result:
// a margin that leaves nothing, more than 4 million points, no point left; a part of the area that
// no cell of a rule reaches (see grid_coverage.h), even if each is divided into 3, 5 or 7 along
// both sides; more than a tenth of the points inside solids, if a workplace has made the plane and
// it is horizontal and above the floor. Cells given by count or spacing stay as they are: a missed
// part is a warning, if it is larger than a cell of EN 12464-1. The points of a route are above the
// walking surface (walking_surface.h); points without it, or with an obstacle, are dropped, and it
// is an error if no point has a floor. why_not: the error, without the plane's name; may be null.
std::optional<SensorGrid> make_sensor_grid(const CalcPlane& plane, const Space& space,
                                           Diagnostics& diagnostics, Message* why_not = nullptr);

}  // namespace calc
