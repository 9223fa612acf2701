#pragma once
// Predicts the work of a calculation: counts from the schedule, seconds from measured costs.

#include "calc/radiosity/gather/settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// Draw, kernel and shadow ray of a connection, on one thread.  [measured, see cost_model.cpp]
inline constexpr double kConnection_ns = 95.0;

// The work of a plane, as far as it is known before the calculation.
struct PlaneWorkload {
  std::size_t points = 0;
  std::size_t seeing_points = 0;     // that indirect light may reach
  double near_points = 0.0;          // of these, with a surface near enough for short rays
  double exact_direct_rays = 0.0;    // once: towards point openings, and of eyes
  double sampled_direct_rays = 0.0;  // one round towards extended openings, all replicates
  double known_openings = 0.0;       // pairs of points and openings proved free: no ray
  double known_points = 0.0;         // points with such openings, once for each channel
  double obstructed_openings = 0.0;  // pairs with something between, or that it may be: proofs
  bool is_unobstructed = false;      // convex space: none of these rays is traced
};

struct SpaceWorkload {
  std::vector<PlaneWorkload> planes;
  std::size_t channels = 1;
  std::size_t triangles = 0;
  double rays_per_path = 1.0;  // a closed space's; fewer where light escapes
  double vertices_per_path = 0.0;
};

// Shadow rays and further short rays that continue a short ray which meets a surface.
inline constexpr double kRaysPerShortRay = 1.7;

struct Work {
  double light_paths = 0, pool_rays = 0, direct_rays = 0, connection_rays = 0, near_rays = 0;
  double opening_pairs = 0;  // of points and openings of which something is to be proved
};
struct Seconds {
  double prepare = 0, direct = 0, pool = 0, connect = 0, near_field = 0;
  double total() const { return prepare + direct + pool + connect + near_field; }
};
struct Prediction {
  Work work;
  Seconds seconds;   // of the clock, with `threads`
  double bytes = 0;  // results, the largest pool, the scene
};

// Returns the prediction. paths: of one replicate, per plane, the total in its last sampling round;
// 0 for a plane without indirect light. Rounds start with settings.first_paths and double.
Prediction predict(const SpaceWorkload& space, const std::vector<std::uint64_t>& paths,
                   const RadiositySettings& settings, int threads);

// Returns the threads that settings.jobs means on this machine.
int thread_count(const RadiositySettings& settings);

}  // namespace calc
