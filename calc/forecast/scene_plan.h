#pragma once
// What the calculation of a space will do, what it may leave out, and why.

#include "calc/base/names.h"
#include "calc/forecast/cost_model.h"
#include "calc/proofs/skips.h"
#include "calc/radiosity/settings.h"
#include "calc/radiosity/solve.h"
#include "calc/scene/prepared_scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// applies: proved, at least for a part; while_calculating: the proof is sought point by point as
// the work goes on; not_needed: another skip leaves nothing to skip; forbidden: by the settings.
enum class SkipState { applies, not_proved, while_calculating, not_needed, forbidden };

template <>
struct EnumNames<SkipState> {
  static constexpr EnumName<SkipState> list[] = {
      {SkipState::applies, "applies"},
      {SkipState::not_proved, "not proved"},
      {SkipState::while_calculating, "while calculating"},
      {SkipState::not_needed, "not needed"},
      {SkipState::forbidden, "forbidden"}};
};

struct SkipDecision {
  Skip skip;
  SkipState state = SkipState::not_proved;
  std::string why;                    // one sentence, no full stop
  std::vector<std::string> planes;    // ids of the planes it is complete for; empty: not by plane
  std::size_t luminaires = 0;         // unlit_surfaces: how many; dark_pairs: pairs
  std::optional<std::uint32_t> body;  // convex: index into Space::bodies of what stands inside
};

struct PlanePlan {
  std::string plane_id;
  std::size_t points = 0;
  std::size_t luminaires = 0;     // that may light it directly
  std::size_t seeing_points = 0;  // that indirect light may reach
  bool is_exact = false;          // nothing is sampled: one pass, no looks
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

// Traces no ray. Settings must be valid.
ScenePlan make_scene_plan(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                          const RadiositySettings& settings);

}  // namespace calc
