#pragma once
// Samples direct light between the points of a plane, to test whether the points represent it.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace calc {

struct LightBetweenPoints {
  struct Cell {
    std::size_t point = 0;          // of the grid, whose cell it is
    bool is_sample = false;         // in the sample of the whole plane
    std::vector<double> direct_lx;  // [channel]: mean over its places, new, at full output
  };
  std::vector<Cell> cells;  // that were looked at
  std::size_t not_measured =
      0;  // cells of the sample that have no place for it: surfaces lie there
};

struct PlaneOfPoints {
  const CalcPlane* plane;
  const SensorGrid* grid;              // of this plane
  std::vector<std::size_t> also = {};  // points whose cells are looked at in any case
};

struct LookBetween {
  int jobs = 0;                 // threads, see on_threads()
  std::function<bool()> go_on;  // asked often, from any of them; false: no plane is looked at
  int pairs = 1;                // of places in each cell, at least
};

// Returns direct light at pairs of places in cells, opposite each other about the cell's point, so
// that light that changes evenly over the cell gives the value at the point. Of many cells one of
// every n is taken, by chance, at most about 128; fewer where luminaires are thousands. Of few
// cells more pairs are taken. Places outside the area, in holes, in surfaces or solids, or on a
// luminaire are replaced by others, and so are those opposite to them. The places depend on the
// luminaires, their light and their directions, so that aiming at the places moves them. Point
// lists, which have no cells, and quantities of more than one illuminance get no cells. Openings
// are sampled as by add_extended_sources(), one round, to about 5 %. Planes and scene must be of
// `space`. One answer per plane, the same bits for any number of jobs.
std::vector<LightBetweenPoints> light_between_points(const PreparedScene& scene, const Space& space,
                                                     const std::vector<PlaneOfPoints>& planes,
                                                     const LookBetween& look);

}  // namespace calc
