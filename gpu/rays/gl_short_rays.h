#pragma once
// Traces first short rays of the near field, and the light at their hits, by OpenGL.

#include "calc/radiosity/sampling/short_rays.h"
#include "gpu/device/device_thread.h"

#include <cstddef>
#include <memory>

namespace gpu {

// Limits for tests. Results depend on them by rounding at most.
struct HitLimits {
  // Hits that the device has at once: about those of a cast in a room.
  std::size_t hits = 40960;
  std::size_t answer_bytes = std::size_t{1} << 26;  // sums that come back at once
  bool leaves_all = false;                          // to the CPU, after the first step
};

// Returns a caster. Origins and directions are the CPU's, except for rounding of a double; their
// hits are searched in float. The light at hits is the CPU's, too: computed in its precision, with
// its luminaires and vertices. Throws calc::BackendFailure when the device fails.
std::unique_ptr<calc::ShortRayCaster> make_gl_short_rays(std::shared_ptr<DeviceThread> thread,
                                                         const HitLimits& limits = {});

}  // namespace gpu
