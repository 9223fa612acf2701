#pragma once
// Which wall the observers of a glare plane look at.

#include "report/document/document.h"

#include <cstddef>

namespace report {

// Number of the wall that most points of the plane look at, from 1, as planes on walls are
// numbered: by the edges of the room's footprint, several in one line having the number of the
// first. 0: the points look nowhere, or there is no wall there.
std::size_t looked_at_wall(const SpacePart& space, const PlanePart& plane);

}  // namespace report
