#pragma once
// Traces light paths by OpenGL.

#include "calc/radiosity/paths/path_tracer.h"
#include "gpu/device/device_thread.h"

#include <memory>

namespace gpu {

// Returns a tracer. All but the search for hits is computed in double from the same random numbers:
// the vertices are those of the CPU, in the same order, up to rounding of the places on triangles
// (1e-6 of the extent), and up to the few paths whose ray grazes an edge. trace() throws
// calc::BackendFailure when the device fails. The same device gives the same bits for any number of
// threads.
std::unique_ptr<calc::PathTracer> make_gl_path_tracer(std::shared_ptr<DeviceThread> thread);

}  // namespace gpu
