#pragma once
// The shape of an escape route: a centre line of straight legs and a width, seen from above. A
// strip of constant width whose legs meet at mitre lines, which halve the angle at a corner.

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// Sharper turns need two corners, because their mitre would reach far out of the route.
inline constexpr double kSharpestTurn_deg = 120.0;
// Least height between parts of a route above each other: more than the search height for a walking
// surface, see walking_surface.h.
inline constexpr double kLeastHeadroom_m = 1.5;

// A line in world coordinates, metres; z of a corner: approximately the walking surface there.
struct RouteLine {
  std::vector<glm::dvec3> corner_m;
  double width_m = 0.0;
};

// Returns a fault of the line, with corners numbered from 1 and what is allowed; "" if there is
// none: 2 corners or more, each leg with a horizontal length, turns of at most kSharpestTurn_deg,
// at every corner an inner edge that does not fold over, and no part of the strip on another one,
// unless it is kLeastHeadroom_m above it. Requires width > 0.
std::string route_fault(const RouteLine& line);

// A straight piece. Places on it: `along` the leg from its first corner, and `offset` to the left
// of its centre line; metres.
struct RouteLeg {
  glm::dvec2 from_m{0.0}, along{1, 0}, left{0, 1};  // unit vectors
  double length_m = 0.0;                            // horizontal, of the centre line
  double start_m = 0.0;                             // length of the legs before it
  double from_z_m = 0.0, to_z_m = 0.0;
  double begin_slope = 0.0, end_slope = 0.0;  // of the mitre lines: along / offset

  double begin_m(double offset_m) const { return begin_slope * offset_m; }
  double end_m(double offset_m) const { return length_m + end_slope * offset_m; }
  glm::dvec2 place_m(double along_m, double offset_m) const {
    return from_m + along_m * along + offset_m * left;
  }
  // Returns the length of its longer edge; `width_m` of the route.
  double longer_edge_m(double width_m) const;
  // Returns a point at the line's height there: linear between corners, constant beyond them.
  glm::dvec3 point_m(double along_m, double offset_m) const;
};

// Returns the legs of a line without fault; at least one.
std::vector<RouteLeg> route_legs(const RouteLine& line);

// Returns the horizontal length of the centre line.
double route_length_m(const RouteLine& line);

// Returns the edge of the strip in world x and y: along the right side, back along the left one,
// counter-clockwise. Corners may coincide where an inner edge has no length.
std::vector<glm::dvec2> route_outline_m(const RouteLine& line);

// The strip as cells: rows of constant offset (row 0 on the right), the stations of every leg
// evenly between its mitre lines, so that every row has as many. Columns count stations over all
// legs. Neighbours share their sides, without overlaps and gaps.
class RouteCells {
 public:
  // stations: of each leg, at least 1; rows: at least 1. line: without fault.
  RouteCells(const RouteLine& line, std::vector<int> stations, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double offset_m(int row) const;                  // of the row's centres
  double station_m(int column) const;              // of the column's middle, on the centre line
  glm::dvec3 centre_m(int column, int row) const;  // at the height of the line
  // Return the distance from the first and to the last end of the route, along the first and the
  // last leg; infinite on the others.
  double from_begin_m(int column, int row) const;
  double from_end_m(int column, int row) const;
  // Returns convex, counter-clockwise corners in world x and y; two coincide where the inner edge
  // has no length.
  std::vector<glm::dvec2> corners_m(int column, int row) const;
  double area_m2(int column, int row) const;

 private:
  struct Place {
    std::size_t leg;
    double begin, end;  // of the leg's stations, [0, 1]
  };
  Place place_of(int column) const;
  double along_m(const RouteLeg& leg, double part, double offset_m) const;

  std::vector<RouteLeg> legs_;
  std::vector<int> stations_;
  std::vector<int> first_column_;
  double width_m_;
  int columns_ = 0, rows_;
};

// Returns the stations of each leg so that they are nowhere farther apart than `spacing_m` > 0, not
// even along the longer edge. They are doubles, because there may be too many for an int.
std::vector<double> route_stations(const RouteLine& line, double spacing_m);

}  // namespace calc
