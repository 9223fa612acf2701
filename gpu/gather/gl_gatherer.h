#pragma once
// Computes the same sum over light vertices as the CPU by OpenGL.

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/device/device_thread.h"
#include "gpu/gather/draw_piece.h"

#include <memory>

namespace gpu {

// Returns a gatherer on that device. Its calls throw calc::BackendFailure when the device fails.
//
// Draws have the same bits as on the CPU. Contributions are computed in float, and sums in double
// in an order of their own: the same device gives the same bits for any number of threads. Its sums
// differ from the CPU's by rounding (1e-6), and by whole connections where a ray grazes an edge.
// limits: results do not depend on them.
std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::shared_ptr<DeviceThread> thread,
                                                 const DrawLimits& limits = {});

}  // namespace gpu
