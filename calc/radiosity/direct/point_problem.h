#pragma once
// Points at which nothing can be measured, and sources whose light nobody can tell.

#include "calc/base/message.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/scene/sensor_grid.h"

#include <span>
#include <string>

namespace calc {

// Why the first such point of a plane cannot be computed; "" if all can. receivers: receivers_of()
// the grid.
// - It lies inside a luminous body, or at a luminaire without size.
// - refuses_close: a surface is so close to where its rays begin that they miss it: nearer than one
//   ray offset, or about two where the point looks at it. Only what reaches farther in front of a
//   planar point than Tracer::touching_m() counts; for points that lie in other surfaces the grid
//   has a shift off them.
Message point_problem(const Tracer& tracer, const SensorGrid& grid,
                      std::span<const Receiver> receivers, bool refuses_close);

// Why light of the first such luminaire cannot be computed; "" if all can: a surface stands before
// its opening, nearer than rays from it or to it begin, which would pass it by. Of the side along
// its axis and, if the luminaire sends light straight up, the other one.
Message source_problem(const Tracer& tracer);

}  // namespace calc
