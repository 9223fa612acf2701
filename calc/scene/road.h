#pragma once
// A straight road with even rows of luminaires, as a project describes it: plain data. What is
// calculated of it is in calc/road.

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace calc {

struct Luminaire;

// The road's own frame, metres: x along it, the way that traffic of lanes that are not oncoming
// goes; y across it to the left; z up. y = 0 is the right edge of the carriageway. What is
// calculated is the field from x = 0 to the spacing of the luminaires.
struct Road {
  glm::dvec3 origin_m{0.0};         // of the frame, in the world
  glm::dmat3 world_from_road{1.0};  // a rotation about z
  double spacing_m = 0.0;           // of the luminaires of one row
  double width_m = 0.0;             // of the carriageway
  std::vector<bool> is_oncoming;    // of each lane, from the right edge; all are equally wide
  std::string surface;              // of calc::r_table_names()
  std::optional<double> q0;         // average luminance coefficient; else the table's own
  // How far the ground beside the carriageway counts for the edge illuminance ratio; empty: it does
  // not, as beside another carriageway.
  std::optional<double> right_strip_m, left_strip_m;
  // Of each row the luminaire at or behind x = 0, and of one with several emitters each of them: in
  // the road's frame.
  std::vector<Luminaire> rows;

  // Nobody says of some row which side of its photometry looks to the street.
  bool is_street_assumed = false;

  double lane_m() const { return width_m / static_cast<double>(is_oncoming.size()); }
};

// How many points EN 13201-3 wants along the field: ten, or more so that none is farther than 3 m
// from the next.
int road_points_along(double spacing_m);
// Rows of them, across the carriageway, for its luminance.
inline constexpr int kRoadRowsPerLane = 3;
// And across a strip that people look at for its illuminance: three, or more, not farther than
// 1.5 m.
int road_points_across(double width_m);

// Within how many mounting heights, along and across, luminaires count for the illuminance of a
// point.  [EN 13201-3]
inline constexpr double kRoadReach_heights = 5.0;

}  // namespace calc
