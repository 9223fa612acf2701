#pragma once
// The same sum over light vertices as the CPU's, by OpenGL.

#include "calc/radiosity/gatherer.h"
#include "gpu/device_thread.h"

#include <memory>

namespace gpu {

// A gatherer on that device. gather() throws calc::BackendFailure when the device fails.
//
// Each connection is computed in float on the device and by itself, and their sums are made in
// double on the CPU, in the order of connections: the same device gives the same bits for any
// number of threads. Against the CPU's gatherer sums differ by rounding (1e-6), and by whole
// connections where a ray grazes an edge.
std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::shared_ptr<DeviceThread> thread);

}  // namespace gpu
