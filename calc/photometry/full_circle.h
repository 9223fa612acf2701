#pragma once
// Expands the C-planes that a file stores to planes around the full circle.

#include <cstddef>
#include <vector>

namespace calc {

// Mirror planes of the light: a stored plane at C also counts for these other planes.
enum class PlaneSymmetry {
  axial,     // one plane, equal all around
  none,      // nothing else
  c0_c180,   // 360 - C
  c90_c270,  // 180 - C
  quadrant,  // 180 - C, 180 + C and 360 - C
};

// A plane of the full circle: (1 - weight) x stored plane `first` + weight x stored plane `second`.
// weight is 0 except where a plane at C 0 had to be put between its neighbours, which leaves the
// interpolated light unchanged, and where planes 0 and 360 were both stored (weight 1/2).
struct CirclePlane {
  double c_deg;
  std::size_t first, second;
  double weight;
};

// Returns planes that ascend from 0 to 360 inclusive with equal first and last planes; a single
// plane at 0 for axial. stored_c_deg: ascending, within [-90, 360], covering the range that the
// symmetry leaves free (callers check that); for c90_c270 either 90 to 270 or -90 to 90. Without
// symmetry the planes may stop before 360: empty when the gap is wider than the widest stored step
// or 90 degrees.
std::vector<CirclePlane> full_circle(const std::vector<double>& stored_c_deg,
                                     PlaneSymmetry symmetry);

// Returns the symmetry that the horizontal angles of an LM-63 file of type C state: one angle; 0 to
// 90; 0 to 180; 90 to 270; else `none`, and full_circle() tells whether it can be closed.
PlaneSymmetry symmetry_of_range(const std::vector<double>& c_deg);

}  // namespace calc
