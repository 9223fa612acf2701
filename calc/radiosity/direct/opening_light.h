#pragma once
// Computes direct light of luminaires with an extended opening, by the proof about each: zero where
// all of it is hidden; known except for a small rest where all of it is visible; sampled with
// shadow rays where neither is proved.
//
// The light at a point from a fully visible opening is the mean of a smooth function over the
// opening. A polynomial through a few places of it has a known mean. The rest of all such openings
// together is sampled by few samples, each of an opening chosen in proportion to how much the light
// varies over it. Unbiased whatever the polynomial, so that the error of the whole shows in the
// replicates.  [control variates; METHOD, 2.6]

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

struct OpeningRounds {
  std::uint32_t first = 0, last = 1;  // rounds of samples, first <= i < last
  std::size_t replicates = 1;
  double error_factor = 1.0;  // see RadiositySettings::opening_error_factor
};

// The arrays for the light of one point.
struct OpeningSums {
  double* known_lx;    // [channel * stride], what replicates share; written by round 0
  double* sampled_lx;  // [replicate * replicate_stride + channel * stride], SUM over rounds
  std::size_t stride, replicate_stride;
  float* largest = nullptr;  // raised to the largest sample of what may be hidden; may be null
};

// Returns the proof about one opening, as seen from the receiver; unknown for shapes that are
// always sampled. Requires a luminaire with an extended opening.
Sight opening_sight(const Tracer& tracer, std::size_t luminaire, const Receiver& receiver,
                    bool has_shadows);

// Returns [luminaire]: 1 where a single proof shows that all receivers see all of the opening; 0:
// not known. Receivers should be near each other. Shapes that are always sampled have 0.
std::vector<std::uint8_t> find_free_openings(const Tracer& tracer,
                                             std::span<const Receiver> receivers,
                                             const DirectProofs& proofs);

// Adds the light of all openings at a receiver. key: of the plane and the point.
DirectRays add_openings(const Tracer& tracer, const Receiver& receiver, const DirectProofs& proofs,
                        RandomKey key, const OpeningRounds& rounds, const OpeningSums& sums);

}  // namespace calc
