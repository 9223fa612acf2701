#pragma once
// The place of a source of glare in the field of view, and its weight there.  [CIE 117]

#include <glm/glm.hpp>

#include <optional>

namespace calc {

// The field of sources that count: sideways up to this, upwards less than this, as multiples of the
// distance along the line of sight. A source at exactly 2 does not count: the first row of the grid
// for UGR tables is there, and the example of CIE 190 holds without it.
inline constexpr double kWidestSource = 3.0, kHighestSource = 2.0;

// Returns the upper limit of the table of CIE 117 at this place sideways (0 to 3): 1.7 below 0.4
// sideways, 1.8 below 0.9, else 1.9. From there to 2 there is only the closed form, and programs
// differ in whether sources count there.
double highest_on_table(double sideways);

// A source, or a part of it, as an eye sees it: multiples of the distance along the line of sight.
// look: unit, horizontal.
struct SeenAt {
  double along_m, sideways, upwards;

  SeenAt(const glm::dvec3& to_source, const glm::dvec3& look);

  // Returns whether it is in the field. At its edge a source above is out, a source below is in.
  bool is_in_field() const;
  // Returns whether the table has an index, and not only the closed form.
  bool is_on_table() const;
  // Returns 1 at the edge of the field, less inside it.
  double share_of_field() const;
  bool is_below() const;
};

// Returns Guth's position index of a source at `to_source` (any length) from an eye that looks
// along the unit, horizontal direction `look`:
//   ln p = (35.2 - 0.31889 t - 1.22 exp(-2 t / 9)) 1e-3 s + (21 + 0.26667 t - 0.002963 t^2) 1e-5
//   s^2
// with s the angle between the source and the line of sight, t that between the vertical and the
// plane of both, in degrees.  [closed form of the IES Lighting Handbook; within 12 % of the table
// of CIE 117, and continues above it] Empty outside the field above and for sources below the line
// of sight, for which there is no index.
std::optional<double> guth_index(const glm::dvec3& to_source, const glm::dvec3& look);

// Returns the index of sources below the line of sight, with H the depth and T the distance
// sideways as multiples of that along it, r = hypot(H, T):  p = 1 + 0.8 r up to r = 0.6, beyond it
// 1 + 1.2 r, r <= 3. [Iwata, as in evalglare] Empty for sources above it, and outside the field.
std::optional<double> iwata_index(const glm::dvec3& to_source, const glm::dvec3& look);

}  // namespace calc
