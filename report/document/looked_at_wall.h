#pragma once
// Finds the wall that the observers of a glare plane face.

#include "report/document/document.h"

#include <cstddef>

namespace report {

// Returns the number of the wall that most points of the plane face, from 1, as planes on walls are
// numbered: by the edges of the room's footprint, with the number of the first for several in line.
// 0: the points face nowhere, or no wall is there.
std::size_t looked_at_wall(const SpacePart& space, const PlanePart& plane);

}  // namespace report
