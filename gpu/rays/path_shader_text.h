#pragma once
// Builds the sources of shaders for light paths, direct light and short rays from shaders/ and the
// formulas of calc/.

#include "calc/radiosity/sampling/short_rays.h"

#include <cstdint>
#include <string>
#include <tuple>

namespace gpu {

// How a path's reflections of one round ended: bits of its count, see path_pass.h.
inline constexpr std::uint32_t kPathEndings = 0xc000'0000;
inline constexpr std::uint32_t kPathLives = 0x8000'0000;
inline constexpr std::uint32_t kPathEndedByRay = 0x4000'0000;  // which left no vertex
inline constexpr std::uint32_t kPathEndedByRoulette = 0;
inline constexpr std::uint32_t kPathNotDone = 0xc000'0000;
inline constexpr std::uint32_t kPathDropped = 0xffff'ffff;

// Words of a light-path pass: 32 direction numbers per Sobol' dimension, then jobs.
inline constexpr std::uint32_t kJobSize = 32;
inline constexpr std::uint32_t kJobKey = 21, kJobFirstPath = 23, kJobBatchPaths = 24,
                               kJobFirstSlot = 25;  // before them: scrambles of the dimensions

inline constexpr std::uint32_t kLuminaireSize = 19;  // entries of a luminaire, see path_tables.h

std::string path_starts_shader();
std::string light_path_shader();
std::string path_sums_shader();
std::string path_places_shader();
std::string path_balance_shader();
// Returns the shader. has_light: for the stages below. Only surfaces that may give light count as
// hits; kLitHitSize words for each ray, its triangle in the tree and two doubles.
std::string short_ray_shader(bool has_light);
inline constexpr std::uint32_t kLitHitSize = 5;

// Rays whose hits one invocation lists.
inline constexpr std::uint32_t kRaysPerBlock = 64;
// Numbers of a piece of hits, see hit_pass.h: tiles of its receivers, doubles of the field, floats
// of a calc::ChoiceSource and of a calc::ChoiceLobe.
inline constexpr std::uint32_t kTileOfAll = 0, kTileOfNothing = 1;
inline constexpr std::uint32_t kFieldSmallest = 0, kFieldPerLumen = 1, kFieldAmbient = 2,
                               kFieldNeeded = 3, kFieldLeast = 4;
inline constexpr std::uint32_t kChoiceSize = 19, kLobeSize = 33;

// Steps of a chain that the device computes, with the first. Of 100 hits about 5 continue, of 100
// of these about 5 again; the CPU computes the rest.
inline constexpr std::uint32_t kChainSteps = 3;
// Continued chains: a word per step with their number, then the places they continue from.
inline constexpr std::uint32_t kChainHead = 16, kChainSize = 12;
static_assert(kChainSteps < kChainHead);
// A hit with its chain has kEndSize words; kMostPortions: consecutive channels of its light, from
// each step a luminaire and kPlacesPerHit draws.
inline constexpr std::uint32_t kFateDone = 0, kFateLeft = 1;  // to the CPU
inline constexpr std::uint32_t kEndSize = 8;
inline constexpr std::uint32_t kPlacesPerHit = std::tuple_size_v<decltype(calc::HitLight::draws)>;
inline constexpr std::uint32_t kMostPortions = kChainSteps * (1 + kPlacesPerHit);
// Dispatches of a later step: an invocation for each place, one for each node of each place, a
// group for each place, an invocation for each draw.
inline constexpr std::uint32_t kDispatchPlaces = 0, kDispatchNodes = 1, kDispatchRows = 2,
                               kDispatchDraws = 3, kDispatches = 4;

// Draws whose vertex is near: the size of a dispatch, their number, and then so many words of each.
inline constexpr std::uint32_t kNearCount = 3, kNearHead = 4, kNearSize = 10;

enum class HitStage {
  counts,
  list,
  bounds,
  later_bounds,
  sizes,
  direct,
  further,
  far,
  near,
  ends,
  sums
};
std::string hit_shader(HitStage stage);

// A point's proof about a luminaire; above it, for sampled ones, samples of one round.
inline constexpr std::uint32_t kPairNothing = 0, kPairHidden = 1, kPairSeen = 2, kPairSampled = 3,
                               kPairLeft = 4;  // to the CPU
inline constexpr std::uint32_t kPairStep = 8;
// Most parts of an opening that a shader visits, and the depth in the tree of halves.
inline constexpr std::uint32_t kMostParts = 64, kDeepestPlace = 31;
// The same at a hit, which has little weight: few, so that it does not delay its neighbours.
inline constexpr std::uint32_t kMostHitParts = 16, kDeepestHitPlace = 8;
// Flags of a chunk's samples; above these bits, its rays.
inline constexpr std::uint32_t kChunkIsLit = 1, kChunkHasHidden = 2, kChunkHasSeen = 4;
inline constexpr std::uint32_t kChunkFlags = 3;

enum class DirectStage { classify, seen, sums, samples, totals };
std::string direct_shader(DirectStage stage);

// Declares is_blocked(), closest_hit() and their parts, for tests and benchmarks.
std::string ray_text();

}  // namespace gpu
