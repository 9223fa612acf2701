#pragma once
// Interface for direct light at many points at once: OpenGL in gpu/. Without an implementation the
// CPU computes it point by point (direct.h, opening_light.h).

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/opening_light.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace calc {

// Points of a plane.
struct DirectBatch {
  const Tracer& tracer;
  std::span<const Receiver> receivers;
  DirectProofs proofs;      // is_free is not looked at
  double deadline_s = 0.0;  // see is_past(); the rest is then left undone, to be thrown away
};

// The results of a batch of n receivers; values are added to all arrays.
struct DirectBatchSums {
  std::span<double> known_lx;    // [channel * n + k], of OpeningSums::known_lx
  std::span<double> sampled_lx;  // [(replicate * channels + channel) * n + k], SUM over rounds
  std::span<float> largest;      // [k], raised as OpeningSums::largest
  std::span<DirectRays> rays;    // [k]
};

class DirectTracer {
 public:
  virtual ~DirectTracer() = default;

  // Does add_point_sources() for every receiver and returns the rays. lx: [channel * n + k], added
  // to. Always the same bits. May be called from several threads at once. May throw BackendFailure.
  virtual std::uint64_t add_point_sources(const DirectBatch& batch, std::span<double> lx) = 0;

  // Does add_openings() for every receiver, with the same random numbers: equal up to rounding, and
  // except for openings for which only the CPU, or only this, has a proof; both ways are unbiased.
  // keys: [k]; sums.sampled_lx holds rounds.replicates replicates.
  virtual void add_openings(const DirectBatch& batch, std::span<const RandomKey> keys,
                            const OpeningRounds& rounds, const DirectBatchSums& sums) = 0;
};

}  // namespace calc
