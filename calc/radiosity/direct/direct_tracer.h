#pragma once
// The seam between direct light and whatever computes it for many points at once: OpenGL in gpu/.
// Where nothing is given, the CPU does it point by point (direct.h, opening_light.h).

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/opening_light.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace calc {

// Points of one plane.
struct DirectBatch {
  const Tracer& tracer;
  std::span<const Receiver> receivers;
  DirectProofs proofs;      // is_free is not looked at
  double deadline_s = 0.0;  // see is_past(); the rest is then left undone, to be thrown away
};

// n: receivers of the batch; all arrays are added to.
struct DirectBatchSums {
  std::span<double> known_lx;    // [channel * n + k], of OpeningSums::known_lx
  std::span<double> sampled_lx;  // [(replicate * channels + channel) * n + k], SUM over rounds
  std::span<float> largest;      // [k], raised as OpeningSums::largest
  std::span<DirectRays> rays;    // [k]
};

class DirectTracer {
 public:
  virtual ~DirectTracer() = default;

  // add_point_sources() of every receiver; returns the rays. lx: [channel * n + k], added to.
  // Always the same bits. May be called from several threads at once. May throw BackendFailure.
  virtual std::uint64_t add_point_sources(const DirectBatch& batch, std::span<double> lx) = 0;

  // add_openings() of every receiver, with the same random numbers: up to rounding, and to
  // openings of which the CPU proves what is not proved elsewhere, or the other way round; both
  // ways are unbiased. keys: [k]; sums.sampled_lx holds rounds.replicates replicates.
  virtual void add_openings(const DirectBatch& batch, std::span<const RandomKey> keys,
                            const OpeningRounds& rounds, const DirectBatchSums& sums) = 0;
};

}  // namespace calc
