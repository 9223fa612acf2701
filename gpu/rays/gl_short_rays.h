#pragma once
// First short rays of the near field, and the light at their hits, by OpenGL.

#include "calc/radiosity/sampling/short_rays.h"
#include "gpu/device/device_thread.h"

#include <cstddef>
#include <memory>

namespace gpu {

// For tests. Results depend on them by rounding at most.
struct HitLimits {
  // That the device has at once: about what a cast meets in a room.
  std::size_t hits = 40960;
  std::size_t answer_bytes = std::size_t{1} << 26;  // sums that come back at once
  bool leaves_all = false;                          // to the CPU, after the first step
};

// Origins and directions are those of the CPU, to the last bit but for rounding of a double; what
// they meet is searched in float. So is the light at hits, which is worked out in the CPU's
// precision and draws the CPU's luminaires and vertices. Throw calc::BackendFailure when the device
// fails.
std::unique_ptr<calc::ShortRayCaster> make_gl_short_rays(std::shared_ptr<DeviceThread> thread,
                                                         const HitLimits& limits = {});

}  // namespace gpu
