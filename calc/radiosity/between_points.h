#pragma once
// What luminaires give directly between the points of a plane: whether the points can stand for it.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace calc {

struct LightBetweenPoints {
  std::vector<std::size_t> point;  // of the grid, whose cells were looked at; empty: of none
  std::vector<double> direct_lx;   // [channel]: mean over these cells, new, at full output
};

struct PlaneOfPoints {
  const CalcPlane* plane;
  const SensorGrid* grid;  // of this plane
};

struct LookBetween {
  int jobs = 0;                 // threads, see on_threads()
  std::function<bool()> go_on;  // asked often, from any of them; false: no plane is looked at
};

// Direct light at two places of each cell, opposite each other about its point, so that light that
// changes evenly over the cell gives what the point has. Of many cells every n-th is taken, about
// 256 at most; fewer where luminaires are thousands. Places outside the area, in holes, in surfaces
// or solids, or on a luminaire are left out, and cells of which one is. Where they are hangs on
// where the luminaires are and whither they shine: who aims at the places moves them. Nothing is
// looked at of point lists, which have no cells, and of quantities that are more than one
// illuminance. Openings are sampled as by add_extended_sources(), one round. Planes must be of
// `space`, and the scene as well. One answer per plane, the same bits for any number of jobs.
std::vector<LightBetweenPoints> light_between_points(const PreparedScene& scene, const Space& space,
                                                     const std::vector<PlaneOfPoints>& planes,
                                                     const LookBetween& look);

}  // namespace calc
