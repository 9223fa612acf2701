#pragma once
// The plan of a space's calculation: its work, what it may leave out, and why.

#include "calc/forecast/cost_model.h"
#include "calc/proofs/skips.h"
#include "calc/radiosity/gather/settings.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/scene/prepared_scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace calc {

struct PlanePlan {
  std::string plane_id;
  std::size_t points = 0;
  std::size_t luminaires = 0;     // that may light it directly
  std::size_t seeing_points = 0;  // that indirect light may reach
  bool is_exact = false;          // nothing is sampled: one pass, no rounds
};

struct ScenePlan {
  std::vector<SkipDecision> skips;  // one per Skip, in their order
  std::vector<PlanePlan> planes;    // one per task, in order
  std::size_t luminaires = 0;
  int looks = 0;  // at most; 0 = nothing is sampled
  int threads = 1;
  SpaceWorkload workload;
  Prediction first_look;  // all planes with first_paths
  Prediction last_look;   // all planes up to max_paths: the most this can cost, but for openings
};

// Returns the plan without tracing light; tests what a few points see of openings. Settings must be
// valid.
ScenePlan make_scene_plan(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                          const RadiositySettings& settings);

}  // namespace calc
