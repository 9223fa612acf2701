#pragma once
// Direct light of luminaires with an opening of some size, by what is proved of each: nothing where
// all of it is hidden; known but for a small rest where all of it is seen; sampled with shadow rays
// where neither is proved.
//
// Of an opening that is seen in full, the light at a point is the mean of a smooth function over
// the opening. A polynomial through a few places of it has a mean that is known; what is left is
// sampled, of all such openings together by few samples, each of an opening chosen in proportion to
// how much the light varies over it. Unbiased whatever the polynomial, so that the error of the
// whole shows in the replicates.  [control variates; METHOD, 2.6]

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

// Where the light of one point goes.
struct OpeningSums {
  double* known_lx;    // [channel * stride], what replicates share; written by round 0
  double* sampled_lx;  // [replicate * replicate_stride + channel * stride], SUM over rounds
  std::size_t stride, replicate_stride;
  float* largest = nullptr;  // raised to the largest sample of what may be hidden; may be null
};

// What is proved of one opening, as seen from the receiver; unknown for shapes that are sampled
// always. May only be asked of luminaires with an opening of some size.
Sight opening_sight(const Tracer& tracer, std::size_t luminaire, const Receiver& receiver,
                    bool has_shadows);

// [luminaire]: 1 where all receivers see all of the opening, by one proof for all of them; 0: not
// known. Receivers should be near each other. Shapes that are sampled always have 0.
std::vector<std::uint8_t> find_free_openings(const Tracer& tracer,
                                             std::span<const Receiver> receivers,
                                             const DirectProofs& proofs);

// key: of the plane and the point.
DirectRays add_openings(const Tracer& tracer, const Receiver& receiver, const DirectProofs& proofs,
                        RandomKey key, const OpeningRounds& rounds, const OpeningSums& sums);

}  // namespace calc
