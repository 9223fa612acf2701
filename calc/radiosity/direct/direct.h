#pragma once
// Computes direct illuminance from luminaires: exact for point openings, sampled over the opening
// for extended ones.

#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/radiosity/sampling/shadow_batch.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

bool has_extended_luminaires(const PreparedScene& scene);

// Proofs about a plane's direct light.
struct DirectProofs {
  // [luminaire]: 1 = gives nothing here (find_dark_luminaires()), left out; may be empty.
  std::span<const std::uint8_t> is_dark;
  bool has_shadows = true;  // false: nothing can stand between (ConvexSpace::holds())
  // [luminaire]: 1 = all of its opening is seen (find_free_openings()); may be empty.
  std::span<const std::uint8_t> is_free = {};

  bool leaves_out(std::size_t luminaire) const {
    return !is_dark.empty() && is_dark[luminaire] != 0;
  }
};

// Results of tracing towards luminaires.
struct DirectRays {
  std::uint64_t traced = 0;
  bool may_be_lit = false;  // some luminaire shines this way, whatever stands between
  bool has_hidden = false;  // something stood between for a sample, or a luminaire
  bool has_seen = false;    // a sample that nothing is proved of arrived
};

// Adds to sums[channel * stride] the direct illuminance (lx) at a receiver from all luminaires with
// a point opening:  E = sum I k / d^2 V (k = cos for a plane).  Exact.
DirectRays add_point_sources(const Tracer& tracer, const Receiver& receiver,
                             const DirectProofs& proofs, double* sums, std::size_t stride);

// Does the same for luminaires with an extended opening, each as points spread evenly over the
// opening with the luminaire's whole intensity distribution [the usual subdivision, with random
// instead of fixed parts: no far-field error near the luminaire, and soft shadows whose error shows
// in the replicates]. first_round..last_round: rounds of samples; opening_cells() gives one round.
// Adds the SUM over rounds of the rounds' means: divide by the number of rounds. Unbiased. largest:
// raised to the largest sample that was added; may be null.
DirectRays add_extended_sources(const Tracer& tracer, const Receiver& receiver,
                                const DirectProofs& proofs, RandomKey key,
                                std::uint32_t first_round, std::uint32_t last_round, double* sums,
                                std::size_t stride, float* largest = nullptr);

// Adds one unbiased sample of the direct illuminance from all luminaires, times weight.
std::uint64_t add_direct_sample(const Tracer& tracer, const Receiver& receiver, RandomKey key,
                                double weight, double* sums, std::size_t stride);

// Does the same for a single luminaire; if its opening is larger than its distance, near parts are
// drawn more often than far ones. receiver: a surface point, planar.
std::uint64_t add_direct_sample_of(const Tracer& tracer, std::size_t luminaire,
                                   const Receiver& receiver, RandomKey key, double weight,
                                   double* sums, std::size_t stride);

// Adds samples of one luminaire like add_extended_sources() to a batch. cells: opening_cells().
struct OpeningCell;
void add_opening_samples(ShadowBatch& batch, const Tracer& tracer, std::size_t luminaire,
                         std::span<const OpeningCell> cells, const Receiver& receiver,
                         RandomKey key, std::uint32_t first_round, std::uint32_t last_round,
                         double* sums, std::size_t stride, float* largest);

// A part of an opening in its sample square (OpeningView): [s, s + size_s] x [t, t + size_t], with
// its samples per round.
struct OpeningCell {
  double s = 0.0, t = 0.0, size_s = 1.0, size_t = 1.0;
  std::uint32_t samples = 1;
};

// Returns the parts of an opening, for a body of its visible faces: halved along the longer side
// until every part's diameter is at most its distance from the point, so that 1 / d^2 stays bounded
// right up to the luminaire. Samples per part: a power of two, 1 far away, chosen so that a
// scrambled net's error stays near 0.5 % of the part's unoccluded contribution in one replicate;
// error_factor times that.
//
// For narrow beams (WebSketch::finest_rad()) parts are as small as the beam is wide, seen from the
// point. Parts that send no light there, by the table, are omitted, possibly all of them.
std::vector<OpeningCell> opening_cells(const PlacedLuminaire& luminaire,
                                       const glm::dvec3& position_m, double error_factor = 1.0);

// Returns whether a luminaire with an opening has so narrow a beam, or is so near, that its light
// at one of the points requires such parts.
bool has_fine_beams(const PreparedScene& scene, const DirectProofs& proofs,
                    std::span<const Receiver> receivers);

}  // namespace calc
