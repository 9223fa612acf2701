#pragma once
// Limits of the work of the calculation.

#include "calc/proofs/skips.h"

#include <cstdint>
#include <string>

namespace calc {

// light_pool: many light vertices, of which every point draws its own few by importance.
// instant_radiosity: every point is connected to every vertex of a small shared set [Keller97], for
// comparison.
enum class Method { light_pool, instant_radiosity };

struct RadiositySettings {
  Method method = Method::light_pool;
  SkipSet skips;  // what may be left out once a proof holds; all by default
  std::uint64_t seed = 1;
  int replicates = 16;  // independent repetitions that give the intervals, 4 to 64
  // Light paths of one replicate in the first round, a power of two. Most verdicts are decided
  // then, and the others lose next to nothing by this early round.
  std::uint64_t first_paths = 256;
  std::uint64_t max_paths = 65536;  // of one replicate of one plane, a power of two >= first_paths
  // Largest geometry term of instant radiosity, 1/m^2; 0 = no limit. Light above it is lost.
  double clamp_per_m2 = 0.0;
  // Texels along the edge of the cube maps that replace rays in instant radiosity, one map for each
  // light vertex: a power of two, 16 to 2048; 0 = rays. For a gatherer that connects_all().
  std::uint32_t shadow_map_texels = 0;
  double time_limit_s = 0.0;  // per project; 0 = none. Results then depend on the machine's speed
  // Refuses a plane with points too close to a surface, see point_problem(); false: they get a
  // number that may be far off (for pictures).
  bool refuses_close_points = true;
  // Factor on the usual error of an opening's samples (for pictures); > 0.
  double opening_error_factor = 1.0;
  int jobs = 0;  // threads; 0 = one per core. Never changes a result
};

// Allowed values, for validate() and for readers of settings.
inline constexpr int kFewestReplicates = 4;
inline constexpr int kMostReplicates = 64;
inline constexpr std::uint64_t kFewestPaths = 1;
inline constexpr std::uint64_t kMostPaths = std::uint64_t{1} << 30;  // Sobol' indices are 32-bit
inline constexpr std::uint32_t kFewestShadowMapTexels = 16;
inline constexpr std::uint32_t kMostShadowMapTexels = 2048;

// Returns "" if all values are allowed, else what is wrong and what is allowed.
std::string validate(const RadiositySettings& settings);

}  // namespace calc
