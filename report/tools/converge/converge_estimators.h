#pragma once
// The methods that `luxgate converge` compares. A new method is a line in the table of the .cpp.

#include "calc/radiosity/looks/solve.h"
#include "calc/scene/prepared_scene.h"
#include "gpu/device/device_thread.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// The inputs of all methods.
struct EstimatorContext {
  const calc::PreparedScene& scene;
  const std::vector<calc::PlaneTask>& tasks;
  int replicates;
  int jobs;
  double clamp_per_m2;
  std::shared_ptr<gpu::DeviceThread> device;  // null: no method needs_opengl()
};

struct EstimatorRun {
  std::vector<calc::PlaneField> fields;  // one per task
  calc::SolveTimes times;
  double seconds = 0.0;  // of all replicates, without reading and preparing the scene
  std::uint64_t light_rays = 0, rays = 0;  // of light paths; of everything but direct light
  std::string problem;                     // "" or why there is no result
  bool is_interrupted = false;
};

// Runs a method. paths: of each replicate.
using Estimator =
    std::function<EstimatorRun(const EstimatorContext&, std::uint64_t paths, std::uint64_t seed)>;

// Returns names for messages: "core", ..., "shadow-map:N".
std::vector<std::string_view> estimator_names();
// Returns "" or what is wrong with a method's name. "shadow-map:128" is valid, with 128 texels
// along a cube's edge.
std::string estimator_problem(const std::string& name);

// Returns the title of a method. name: without an estimator_problem(), below too.
std::string estimator_title(const std::string& name);
bool needs_opengl(const std::string& name);
// Returns the method. It keeps what is opened or compiled once for many runs, which is in no run's
// time.
Estimator find_estimator(const std::string& name);

}  // namespace cli
