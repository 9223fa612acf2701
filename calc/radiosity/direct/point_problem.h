#pragma once
// Finds points at which nothing can be measured, and sources whose light cannot be computed.

#include "calc/base/message.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/scene/sensor_grid.h"

#include <span>
#include <string>

namespace calc {

// Returns why the first such point of a plane cannot be computed; "" if all can. receivers:
// receivers_of() the grid.
// - It is inside a luminous body, or at a luminaire without size.
// - refuses_close: a surface is so near the start of its rays that they miss it: nearer than one
//   ray offset, or about two where the point looks at it. Only a surface that reaches farther in
//   front of a planar point than Tracer::touching_m() counts; for points in other surfaces the grid
//   has a shift off them.
Message point_problem(const Tracer& tracer, const SensorGrid& grid,
                      std::span<const Receiver> receivers, bool refuses_close);

// Returns why light of the first such luminaire cannot be computed; "" if all can: a surface in
// front of its opening is nearer than the start of rays from it or to it, which would miss it.
// Tests the side along its axis and, if the luminaire sends light straight up, the other one.
Message source_problem(const Tracer& tracer);

}  // namespace calc
