#pragma once
// A plane after a sampling round, as bytes: stored under LookKey, and read by a later run instead
// of computing the round.

#include "calc/radiosity/gather/plane_state.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Data of the space from a round: the same for every plane, stored with each.
struct LookLight {
  double emitted_lm = 0.0, untraced_lm = 0.0;   // as FluxBalance
  bool has_paths = false;                       // light paths were traced for this plane
  std::vector<double> absorbed_lm, escaped_lm;  // [replicate], of this round's paths only
  std::uint64_t pool_rays = 0;                  // of this round's paths
};

// A plane after a round, or after its exact light where nothing is sampled.
struct StoredLook {
  bool is_exact = false;
  LookLight light;
  std::vector<double> direct_exact_lx;
  GlareField glare;
  SolveCounters counters;  // without active_points, which publish() counts
  PlaneSums sums;
};

// Returns the largest number of bytes of a round of this plane.
std::size_t most_look_bytes(const PlaneState& plane);

std::string render_look(const PlaneState& plane, bool is_exact, const LookLight& light);

// Returns the round with the sizes of `plane`, whatever the bytes state; empty if they are not a
// round of such a plane.
std::optional<StoredLook> parse_look(std::string_view bytes, const PlaneState& plane);

// Restores the plane's state after the round, except for publish().
void restore(StoredLook look, PlaneState& plane);

}  // namespace calc
