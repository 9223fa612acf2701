#pragma once
// Grid aliasing: points that are all at the same place between luminaires. By EN 12464-1 the
// spacing of a grid must not be that of the luminaires.

#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace calc {

struct GridAliasing {
  glm::dvec3 along{0.0};            // the grid's axis, unit
  double points_m = 0.0;            // spacing of the points along it
  double luminaires_m = 0.0;        // mean spacing of a row of luminaires along it
  std::string first_id, last_id{};  // ends of the longest such row, of what is near the plane
};

// Returns an axis of a level plane along which all points are at the same place between the
// luminaires in front of it, so that minimum and average are those of that place only.
//
// A row: luminaires of one type, level in the scene and height, in a line along the axis, however
// they were written. A point's phase in it is its share of the way from one luminaire to the next,
// from 0 to 1, continued beyond both ends by one more spacing. The row is aliased if every point is
// at least one luminaire further than the point before it, and all phases are within a quarter of a
// spacing. Such points cannot include both the brightest and the darkest place of a row, half a
// spacing apart, and their mean still has nine tenths of the ripple (sin(pi/4) / (pi/4)). This
// finds points 1, 2, 3 ... spacings apart, but not those half a spacing apart: with two phases the
// average no longer contains the first harmonic of the ripple, by far the largest.
//
// Rows with even light do not count, because no place differs from another: lines of light, and
// luminaires close together for their height. Light is even if its darkest place has at least 95 %
// of the brightest, right below the row and at half its height and its height beside it, wherever
// that has a tenth of the row's most. The plane is aliased if aliased rows give at least half of
// the flux towards it, of the luminaires within their height beside it. Empty also for planes that
// are not level, planar and with cells.
//
// scene: null, and everything is at full output. Work: luminaires x log(luminaires) + points, and
// some 10,000 intensities for each kind of row that is a trap.
std::optional<GridAliasing> grid_aliasing(const Project& project, const Space& space,
                                          const SensorGrid& grid, const LightScene* scene);

}  // namespace calc
