#pragma once
// The methods that `luxgate converge` compares. A new one is a line in the table of the .cpp.

#include "calc/radiosity/solve.h"
#include "calc/scene/prepared_scene.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// What all methods are given.
struct EstimatorContext {
  const calc::PreparedScene& scene;
  const std::vector<calc::PlaneTask>& tasks;
  int replicates;
  int jobs;
  double clamp_per_m2;
};

struct EstimatorRun {
  std::vector<calc::PlaneField> fields;  // one per task
  calc::SolveTimes times;
  double seconds = 0.0;  // of all replicates, without reading and preparing the scene
  std::uint64_t light_rays = 0, rays = 0;  // of light paths; of everything but direct light
  std::string problem;                     // "" or why there is no result
  bool is_interrupted = false;
};

// paths: of each replicate.
using Estimator =
    std::function<EstimatorRun(const EstimatorContext&, std::uint64_t paths, std::uint64_t seed)>;

std::vector<std::string_view> estimator_names();
std::string_view estimator_title(std::string_view name);
// name: one of estimator_names().
Estimator find_estimator(std::string_view name);

}  // namespace cli
