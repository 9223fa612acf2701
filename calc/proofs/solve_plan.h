#pragma once
// Decides and explains what the calculation of a space omits, once, before the first ray. The
// solver follows this, the plan prints it, the forecast counts it.

#include "calc/proofs/beam.h"
#include "calc/proofs/skips.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace calc {

// A plane to compute: its id keys the random numbers, so that a plane's result does not depend on
// the other planes or their order.
struct PlaneTask {
  std::string plane_id;
  const SensorGrid* grid;
};

struct PlaneDecision {
  std::size_t points = 0;     // of the grid
  std::size_t receivers = 0;  // points times receivers_per_point()
  // [point]: 0 = proved that no reflected light reaches it, even if that must not be used.
  std::vector<std::uint8_t> may_see_reflection;
  std::vector<std::uint8_t> gathers_reflection;  // [point]: 1 = rounds add reflected light to it
  std::vector<std::uint8_t> is_dark;  // [luminaire]: 1 = left out; empty: none is left out
  bool measures_direct = true;        // false: eyes, whose direct light is glare
  bool samples_openings = false;      // light straight from extended openings is sampled
  bool samples_reflection = false;    // of any point
  bool is_unobstructed = false;       // no shadow ray from its points

  std::size_t gathering_points() const;
  std::size_t dark_luminaires() const;  // that are left out
  bool is_exact() const { return !samples_openings && !samples_reflection; }
};

struct SolvePlan {
  bool has_reflection = false;         // some surface reflects
  std::vector<std::uint8_t> is_unlit;  // [luminaire]: 1 = no light path; empty: none is left out
  bool samples_indirect = false;       // light paths are traced at all
  bool is_convex = false;              // no shadow ray between surfaces and luminaires
  std::string why_not_convex;          // a clause; "" if is_convex or not sought
  std::optional<std::uint32_t> obstacle_body;  // index into Space::bodies, of what stands inside
  std::vector<PlaneDecision> planes;           // one per task, in order
};

// Returns the plan without tracing rays. Grids must outlive only the call.
SolvePlan decide(const PreparedScene& scene, std::span<const PlaneTask> tasks,
                 const SkipSet& allowed);

// Returns one decision per Skip, in their order. plan: decide() of the same arguments.
// has_light_pool: light paths are gathered from a pool of vertices.
std::vector<SkipDecision> explain_skips(const SolvePlan& plan, const PreparedScene& scene,
                                        std::span<const PlaneTask> tasks, const SkipSet& allowed,
                                        bool has_light_pool);

// Returns only SolvePlan::is_unlit. beams: beams_of(scene).
std::vector<std::uint8_t> unlit_luminaires(const PreparedScene& scene,
                                           const std::vector<Beam>& beams, const SkipSet& allowed);

}  // namespace calc
