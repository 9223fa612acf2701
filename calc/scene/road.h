#pragma once
// A straight road with even rows of luminaires, as a project describes it: plain data. calc/road
// calculates its values.

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace calc {

struct Luminaire;

// The road's own frame, metres: x along it, in the traffic direction of lanes that are not
// oncoming; y across it to the left; z up. y = 0 is the right edge of the carriageway. The
// calculated field extends from x = 0 to the spacing of the luminaires.
struct Road {
  glm::dvec3 origin_m{0.0};         // of the frame, in the world
  glm::dmat3 world_from_road{1.0};  // a rotation about z
  double spacing_m = 0.0;           // of the luminaires of one row
  double width_m = 0.0;             // of the carriageway
  std::vector<bool> is_oncoming;    // of each lane, from the right edge; all are equally wide
  std::string surface;              // of calc::r_table_names()
  std::optional<double> q0;         // average luminance coefficient; else the table's own
  // Width of the ground beside the carriageway for the edge illuminance ratio; empty: it does not
  // count, as beside another carriageway.
  std::optional<double> right_strip_m, left_strip_m;
  // For each row the luminaire at or behind x = 0, with several emitters each of them; in the
  // road's frame.
  std::vector<Luminaire> rows;

  // The side of the photometry that faces the street is not stated for some row.
  bool is_street_assumed = false;

  double lane_m() const { return width_m / static_cast<double>(is_oncoming.size()); }
};

// Returns the points along the field by EN 13201-3: ten, or more so that neighbours are at most 3 m
// apart.
int road_points_along(double spacing_m);
// Rows of points across the carriageway, for its luminance.
inline constexpr int kRoadRowsPerLane = 3;
// Returns the rows of points across a strip for its illuminance: three, or more, not farther apart
// than 1.5 m.
int road_points_across(double width_m);

// Mounting heights, along and across, within which luminaires count for the illuminance of a point.
// [EN 13201-3]
inline constexpr double kRoadReach_heights = 5.0;

}  // namespace calc
