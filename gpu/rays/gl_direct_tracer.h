#pragma once
// Computes direct light by OpenGL.

#include "calc/radiosity/direct/direct_tracer.h"
#include "gpu/device/device_thread.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace gpu {

// The work sent and done at a time; results depend only on the last number.
struct DirectLimits {
  std::size_t pairs = std::size_t{1} << 20;       // of points and luminaires, times rounds
  std::size_t chunk_sums = std::size_t{1} << 21;  // of chunks of samples and replicates, in one go
  std::uint32_t chunk = 32;  // samples of an opening that one invocation takes; these do matter:
                             // sums of chunks are added, which is a rounding
};
// Returns the limits of a device: slow software gets less work between two looks at the clock.
DirectLimits direct_limits(const Device& device);

// Returns a tracer. Proofs of sight, light of visible openings, samples where nothing is proved,
// and their sums are made on the device, from the random numbers of the CPU. Rays are searched in
// float, places of patches are read in float as on the CPU, all else is computed in double. The CPU
// computes points so near to an opening that it has many parts. The same device gives the same bits
// for any number of threads. Calls throw calc::BackendFailure when the device fails.
std::unique_ptr<calc::DirectTracer> make_gl_direct_tracer(std::shared_ptr<DeviceThread> thread);
std::unique_ptr<calc::DirectTracer> make_gl_direct_tracer(std::shared_ptr<DeviceThread> thread,
                                                          const DirectLimits& limits);

}  // namespace gpu
