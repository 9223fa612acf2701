#pragma once
// Instant radiosity with data made once per light vertex for all planes: shadow maps.

#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/gather/plane_work.h"

#include <span>

namespace calc {

// Adds one replicate's indirect light of all these planes, by Gatherer::gather_all(): once for
// planes whose points may be shadowed, once for those proved to see every vertex. A plane's sums do
// not depend on the others. May throw BackendFailure.
void gather_all_planes(const Tracer& tracer, std::span<PlaneWork* const> planes,
                       const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times);

}  // namespace calc
