#pragma once
// First short rays of the near field, and the light at their hits, by OpenGL.

#include "calc/radiosity/short_rays.h"
#include "gpu/device_thread.h"

#include <cstddef>
#include <memory>

namespace gpu {

// Hits that the device has at once. No result depends on it.
struct HitLimits {
  std::size_t hits = std::size_t{1} << 15;
};

// Origins and directions are those of the CPU, to the last bit but for rounding of a double; what
// they meet is searched in float. So is the light at hits, which is worked out in the CPU's
// precision and draws the CPU's luminaires and vertices. Throw calc::BackendFailure when the device
// fails.
std::unique_ptr<calc::ShortRayCaster> make_gl_short_rays(std::shared_ptr<DeviceThread> thread,
                                                         const HitLimits& limits = {});

}  // namespace gpu
