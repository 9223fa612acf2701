#pragma once
// Computes illuminance by paths from the points: an independent, simple and slow method that shares
// neither light vertices nor bounds with the first. For comparison and tests.

#include "calc/base/field.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/scene/sensor_grid.h"

#include <cstdint>
#include <functional>
#include <string>

namespace calc {

struct PathTracingSettings {
  std::uint64_t paths = 1024;  // from each point, of one replicate; 1 to 2^30
  int replicates = 16;         // >= 2
  std::uint64_t seed = 1;
  std::function<bool()> goes_on;  // asked at every point, on any thread; may be empty. False: the
                                  // rest is left undone, and the field has a `problem`
};

// Traces rays with density cos / pi (evenly on the sphere for receivers without a back); direct
// light of all luminaires at every hit; from the second hit on roulette with the reflectance.
// Unbiased; replicates are independent. Direct light at the points is as for planes: exact for
// point openings. counters.near_rays counts rays of paths. A path of more than kMostReflections
// gives a field with a `problem`. Parallel inside; the same bits for any number of threads.
PlaneField trace_from_points(const Tracer& tracer, const std::string& plane_id,
                             const SensorGrid& grid, const PathTracingSettings& settings);

}  // namespace calc
