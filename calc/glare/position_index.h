#pragma once
// Where in the field of view a source of glare is, and how much it counts there.  [CIE 117]

#include <glm/glm.hpp>

#include <optional>

namespace calc {

// The field of sources that count: sideways up to this, upwards less than this, as multiples of the
// distance along the line of sight. At exactly 2 a source is out: the first row of the grid that
// UGR tables are made on lies there, and the example of CIE 190 holds without it.
inline constexpr double kWidestSource = 3.0, kHighestSource = 2.0;

// Up to where the table of CIE 117 has an index, with so much sideways (0 to 3): 1.7 below 0.4
// sideways, 1.8 below 0.9, else 1.9. From there to 2 there is the closed form only, and programs
// differ in whether sources count there.
double highest_on_table(double sideways);

// Of a source, or a part of one, as an eye sees it: multiples of the distance along the line of
// sight. look: unit, horizontal.
struct SeenAt {
  double along_m, sideways, upwards;

  SeenAt(const glm::dvec3& to_source, const glm::dvec3& look);

  // Where it ends above a source is out, below one is in: so none is passed over without a word.
  bool is_in_field() const;
  // Where the table has an index, and not only the closed form.
  bool is_on_table() const;
  // 1 where the field ends, less inside it.
  double share_of_field() const;
  bool is_below() const;
};

// Guth's position index of a source at `to_source` (any length) from an eye that looks along the
// unit, horizontal direction `look`:
//   ln p = (35.2 - 0.31889 t - 1.22 exp(-2 t / 9)) 1e-3 s + (21 + 0.26667 t - 0.002963 t^2) 1e-5
//   s^2
// with s the angle between the source and the line of sight, t that between the vertical and the
// plane of both, in degrees.  [closed form of the IES Lighting Handbook; within 12 % of the table
// of CIE 117, and goes on above it] Empty outside the field above and for sources below the line of
// sight, for which there is no index.
std::optional<double> guth_index(const glm::dvec3& to_source, const glm::dvec3& look);

// For sources below the line of sight, with H the depth and T the distance sideways as multiples of
// that along it, r = hypot(H, T):  p = 1 + 0.8 r up to r = 0.6, beyond it 1 + 1.2 r, r <= 3.
// [Iwata, as in evalglare] Empty for sources above it, and outside the field.
std::optional<double> iwata_index(const glm::dvec3& to_source, const glm::dvec3& look);

}  // namespace calc
