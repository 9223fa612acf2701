#pragma once
// First short rays of the near field by OpenGL.

#include "calc/radiosity/short_rays.h"
#include "gpu/device_thread.h"

#include <memory>

namespace gpu {

// Origins and directions are those of the CPU, to the last bit but for rounding of a double; what
// they meet is searched in float. cast() throws calc::BackendFailure when the device fails.
std::unique_ptr<calc::ShortRayCaster> make_gl_short_rays(std::shared_ptr<DeviceThread> thread);

}  // namespace gpu
