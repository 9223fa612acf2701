#pragma once
// A plane after a look, as bytes: what is stored under LookKey, and what a run takes from there in
// place of the look.

#include "calc/radiosity/gather/plane_state.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// What a look tells of its space: the same for every plane, kept with each.
struct LookLight {
  double emitted_lm = 0.0, untraced_lm = 0.0;   // as FluxBalance
  bool has_paths = false;                       // light paths were traced for this plane
  std::vector<double> absorbed_lm, escaped_lm;  // [replicate], of this look's paths alone
  std::uint64_t pool_rays = 0;                  // of this look's paths
};

// A plane as it stands after a look, or after its exact light where nothing is sampled.
struct StoredLook {
  bool is_exact = false;
  LookLight light;
  std::vector<double> direct_exact_lx;
  GlareField glare;
  SolveCounters counters;  // without active_points, which publish() counts
  PlaneSums sums;
};

// Bytes that a look of this plane takes at most.
std::size_t most_look_bytes(const PlaneState& plane);

std::string render_look(const PlaneState& plane, bool is_exact, const LookLight& light);

// Sizes are those of `plane`, whatever the bytes say. Empty: these are not the bytes of a look of
// such a plane.
std::optional<StoredLook> parse_look(std::string_view bytes, const PlaneState& plane);

// The plane is then as after the look, but for publish().
void restore(StoredLook look, PlaneState& plane);

}  // namespace calc
