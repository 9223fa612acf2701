#pragma once
// Calculation points that all stand in the same place between luminaires: by EN 12464-1 the spacing
// of a grid must not be that of the luminaires.

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

// Whether, along one of its axes, all points of a level plane stand in the same place between the
// luminaires before it, so that a minimum and an average are those of that place alone.
//
// A row: luminaires of one type, level in the scene and height, in a line along the axis, however
// they were written. A point's phase in it is how far it has got from one luminaire to the next,
// from 0 to 1, counted on beyond both ends by one more spacing. The row is a trap if every point is
// at least one luminaire further than the one before it, and all phases are within a quarter of a
// spacing. So close they cannot hold the brightest place of a row and the darkest one, half a
// spacing apart, and their mean still has nine tenths of the ripple (sin(pi/4) / (pi/4)). Points 1,
// 2, 3 ... spacings apart are thus found, and those of half a spacing are not: with two phases the
// first harmonic of the ripple, by far the largest, is not in the average any more.
//
// Not counted: rows whose own light is even, so that no place differs from another: lines of light,
// and luminaires close together for their height. Even is light of which the darkest place has at
// least 95 % of the brightest, right below the row and at half its height and its height beside it,
// wherever that has a tenth of the row's most. The plane is in the trap if rows with at least half
// of the flux that goes its way, of the luminaires within their height beside it, are traps. Empty
// also of planes that are not level, planar and with cells.
//
// scene: null, and everything is at full output. Work: luminaires x log(luminaires) + points, and
// some 10,000 intensities for each kind of row that is a trap.
std::optional<GridAliasing> grid_aliasing(const Project& project, const Space& space,
                                          const SensorGrid& grid, const LightScene* scene);

}  // namespace calc
