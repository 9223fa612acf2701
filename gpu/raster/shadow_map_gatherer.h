#pragma once
// Instant radiosity as in its paper: visibility by shadow maps instead of rays.

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/device/device_thread.h"

#include <cstdint>
#include <memory>

namespace gpu {

// Returns a gatherer that connects_all(): one depth map of half a cube around every light vertex,
// drawn by OpenGL with `texels` along a cube's edge (a power of two, 16 to 2048), looked up by all
// points. Sums are made in double on the CPU in the order of vertices: the same device gives the
// same bits for any number of threads.
//
// Not exact: a map has the nearest surface in `texels` directions across each face, so that shadows
// move by up to half a texel: by distance / texels, seen from the vertex. A point behind a surface
// by less than 1e-3 of its distance from the vertex and twice the ray offset counts as on it (the
// depth bias), and points without a plane (all kernels but planar) by less than twice the distance
// over `texels`.
//
// gather_all() throws calc::BackendFailure when the device fails; gather() always.
std::unique_ptr<calc::Gatherer> make_shadow_map_gatherer(std::shared_ptr<DeviceThread> thread,
                                                         std::uint32_t texels);

}  // namespace gpu
