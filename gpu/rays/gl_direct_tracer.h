#pragma once
// Direct light by OpenGL.

#include "calc/radiosity/direct/direct_tracer.h"
#include "gpu/device/device_thread.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace gpu {

// How much is sent and done at a time; results do not depend on it, but for the last.
struct DirectLimits {
  std::size_t pairs = std::size_t{1} << 20;       // of points and luminaires, times rounds
  std::size_t chunk_sums = std::size_t{1} << 21;  // of chunks of samples and replicates, in one go
  std::uint32_t chunk = 32;  // samples of an opening that one invocation takes; these do matter:
                             // sums of chunks are added, which is a rounding
};
// Of a device: software is slow, and is asked for less between two looks at the clock.
DirectLimits direct_limits(const Device& device);

// Proofs of sight, light of what is seen, samples of what is not known, and their sums are made on
// the device, from the random numbers of the CPU. Rays are searched in float, places of patches are
// read in float as on the CPU, all else is computed in double. Points so near to an opening that it
// falls into many parts are done by the CPU. The same device gives the same bits for any number of
// threads. Calls throw calc::BackendFailure when the device fails.
std::unique_ptr<calc::DirectTracer> make_gl_direct_tracer(std::shared_ptr<DeviceThread> thread);
std::unique_ptr<calc::DirectTracer> make_gl_direct_tracer(std::shared_ptr<DeviceThread> thread,
                                                          const DirectLimits& limits);

}  // namespace gpu
