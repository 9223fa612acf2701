#pragma once
// The same sum over light vertices as the CPU's, by OpenGL.

#include "calc/radiosity/gatherer.h"
#include "gpu/egl_context.h"

#include <memory>
#include <string>

namespace gpu {

struct GathererRequest {
  int device = -1;  // as in list_devices(); -1 = preferred_device()
  Fault fault = Fault::none;
};

// A gatherer on that device, with a thread of its own that owns the context. Null if there is none;
// `problem` then says why in words, for the user. The caller must not fall back to another backend
// unasked. gather() throws calc::BackendFailure when the device fails.
//
// Each connection is computed in float on the device and by itself, and their sums are made in
// double on the CPU, in the order of connections: the same device gives the same bits for any
// number of threads. Against the CPU's gatherer sums differ by rounding (1e-6), and by whole
// connections where a ray grazes an edge.
std::unique_ptr<calc::Gatherer> make_gl_gatherer(const GathererRequest& request, Device& device,
                                                 std::string& problem);

}  // namespace gpu
