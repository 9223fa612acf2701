#pragma once
// Measures how much light leaves a surface model: is a room closed?

#include "calc/base/field.h"
#include "calc/meshes/mesh_check.h"

#include <cstdint>

namespace cli {

// The share of rays that leave. Inside is a point of the bounding box from which most rays cross an
// odd number of surfaces; in models that need not be one closed sheet (walls with two faces) also a
// point from which nearly no ray leaves.
struct Escape {
  double inside_share = 0.0;  // of the box's volume; 0 = nothing is inside
  std::uint64_t points = 0;   // inside, one ray each
  calc::Estimate share;       // of light that leaves, from points spread evenly inside, the same
                              // into all directions; 95 % interval [Wilson27]
};

// Measures with random points and rays of a fixed seed: the same model gives the same numbers.
// is_sheet: the model is one sheet around the inside, possibly with closed things in it.
Escape measure_escape(const calc::SurfaceModel& model, const calc::BoundingBox& bounds_m,
                      bool is_sheet);

}  // namespace cli
