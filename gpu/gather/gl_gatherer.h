#pragma once
// The same sum over light vertices as the CPU's, by OpenGL.

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/device/device_thread.h"
#include "gpu/gather/draw_piece.h"

#include <memory>

namespace gpu {

// A gatherer on that device. Its calls throw calc::BackendFailure when the device fails.
//
// Draws are those of the CPU, in bits. What a connection adds is computed in float, and sums are
// made in double in an order of their own: the same device gives the same bits for any number of
// threads. Against the CPU's gatherer sums differ by rounding (1e-6), and by whole connections
// where a ray grazes an edge. limits: results do not depend on them.
std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::shared_ptr<DeviceThread> thread,
                                                 const DrawLimits& limits = {});

}  // namespace gpu
