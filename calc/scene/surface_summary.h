#pragma once
// Summarises all surfaces of a space.

#include "calc/scene/prepared_scene.h"

namespace calc {

struct SurfaceSummary {
  double area_m2 = 0.0;           // 0 without surfaces
  double mean_reflectance = 0.0;  // by area, [0, 1]
  // 4 V / S of the bounding box, > 0: the mean chord of a convex body [Santalo76]. A flat scene has
  // no volume and uses its extent.
  double mean_free_path_m = 1.0;
};

SurfaceSummary summarise_surfaces(const PreparedScene& scene);

}  // namespace calc
