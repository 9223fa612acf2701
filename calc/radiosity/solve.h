#pragma once
// Illuminance of every plane of a space: direct light, light-vertex pool, connections, near field,
// looks.

#include "calc/field.h"
#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/plane_work.h"
#include "calc/radiosity/settings.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"

#include <functional>
#include <string>
#include <vector>

namespace calc {

// A plane to compute: its id keys the random numbers, so that a plane's result does not depend on
// which other planes are computed or in which order.
struct PlaneTask {
  std::string plane_id;
  const SensorGrid* grid;
};

// Asked after every look (sample sizes double): is this plane's field accurate enough?
using AccuracyTest = std::function<bool(std::size_t task, const PlaneField& field)>;

// Told after every look; may be empty. Return false to stop the calculation
// (StopReason::interrupted).
struct SolveProgress {
  std::size_t planes_done = 0, planes = 0;
  std::uint64_t paths_per_replicate = 0;
};
using ProgressSink = std::function<bool(const SolveProgress&)>;

struct SpaceSolution {
  std::vector<PlaneField> fields;  // one per task, in order
  FluxBalance balance;             // of all light paths traced; emitted only when none was needed
  SolveTimes times;
  std::uint64_t pool_rays = 0;  // rays of all light paths
};

// Settings must be valid. Same scene, task and seed give the same bits for any settings.jobs and
// any other tasks, unless a time limit or the progress sink stopped the run.
SpaceSolution solve_illuminance(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                                const RadiositySettings& settings, double confidence,
                                Gatherer& gatherer, const AccuracyTest& is_accurate,
                                const ProgressSink& progress);

}  // namespace calc
