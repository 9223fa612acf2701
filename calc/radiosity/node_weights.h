#pragma once
// The inner loop that weighs groups of light vertices for one receiver.

#include <cstddef>

namespace calc {

// Vertices that stand for a group when it is weighed.
inline constexpr std::size_t kRepresentatives = 1;

// Arrays of a cut with `nodes` entries, of representatives [representative * nodes + node].
struct CutArrays {
  std::size_t nodes;
  const float *flux_lm, *radius2_m2, *bound_per_m2, *centre_x, *centre_y, *centre_z;
  const float *x, *y, *z, *nx, *ny, *nz;
};

// For a planar receiver at p with normal n:
//   out[c] = flux_c (mean over representatives of min(cos_x cos_y / (d^2 + r^2), b) +
//            e / (dist_c^2 + r^2))
// with the node's radius r to soften the kernel and e = 0.03 so that no node that may contribute
// has probability 0. b: about the bound of the geometry term.
void weigh_planar(const CutArrays& cut, const float p[3], const float n[3], float* out);
// The same with cos_x = 1, for receivers that look everywhere.
void weigh_round(const CutArrays& cut, const float p[3], float* out);

}  // namespace calc
