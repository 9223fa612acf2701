#pragma once
// The inner loop that weighs groups of light vertices for one receiver.

#include <cstddef>

namespace calc {

// Arrays of a cut with `nodes` entries. x, y, z, nx, ny, nz: of a vertex that represents the node.
struct CutArrays {
  std::size_t nodes;
  const float *flux_lm, *radius_m, *bound_per_m2, *centre_x, *centre_y, *centre_z;
  const float *x, *y, *z, *nx, *ny, *nz;
};

// Computes for a planar receiver at p with normal n
//   out[c] = flux_c (min(cos_x cos_y d^2 / (d^2 + r^2)^2, b) + e min(1 / gap^2, b))
// of the node's vertex at distance d, with the node's radius r to soften the kernel, the gap
// between p and the node's sphere, and e = 0.03, so that no contribution can be much larger than
// its probability. b: about the bound of the geometry term.  [one vertex per node serves as well as
// the mean over four, at the same size of the cut: measured]
void weigh_planar(const CutArrays& cut, const float p[3], const float n[3], float* out);
// Computes the same with cos_x = 1, for receivers that look everywhere.
void weigh_round(const CutArrays& cut, const float p[3], float* out);

// Returns the sum of n values, in an order that depends only on n.
float sum_of(const float* values, std::size_t n);

}  // namespace calc
