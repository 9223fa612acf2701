#pragma once
// What the ray tracer alone would need for the rays of a run.

#include "tests/bench/measure.h"

namespace bench {

// Nanoseconds of wall time per ray, on `threads` threads, best of `repeats`; rays are made before
// the clock starts, each kind as the core traces it: where it starts, where it goes, and in what
// order.
struct RayCosts {
  double connection_ns = 0.0;  // packets of 16 towards light vertices drawn by what they contribute
  double path_ns = 0.0;        // closest hits of light paths, packets bounce by bounce
  double near_ns = 0.0;        // closest hits of short cosine rays from the points, in packets
  double direct_ns = 0.0;      // packets towards luminaires
};
RayCosts measure_rays(const BenchScene& scene, int threads, int repeats);

struct RayLimit {
  double whole_s = 0.0;       // all rays of the run
  double connection_s = 0.0;  // those of its connections
};
RayLimit limit_of(const Run& run, const RayCosts& costs);

}  // namespace bench
