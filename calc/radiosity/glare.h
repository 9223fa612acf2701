#pragma once
// The luminaires that an eye sees, as the unified glare rating weighs them.
//
//   UGR = 8 log10( 0.25 / Lb  sum L^2 w / p^2 ),  Lb = E_ind / pi     [CIE 117]
//
// Here: the sum, of the direct light, without noise. E_ind, the illuminance of the eye by reflected
// light alone, is sampled like every other (DerivedQuantity::ugr);
// rules/measure/derived_points.h joins them.
//
// L = I / A: luminous intensity towards the eye over the opening's area as seen from there; w = A /
// r^2, r to the opening's centre; both as for an eye far away, of the whole opening. The index p is
// that of the centre. If the centre is outside the field but parts of the opening are on the table
// of indices, each of them counts with its own. Of an opening that is partly hidden, L stays and w
// is the share that is seen, counted on kSightLines^2 lines of sight spread evenly over the
// opening; one straight edge across it is then off by no more than 1 / kSightLines of the opening.
//
// A source of more than 0.1 sr is too large for the formula. What counts is what is seen of it in
// the field, at most: if that is not too large, each seen part in the field counts as a source of
// its own, with its own L, w and p, and `low` and `high` hold what it would count as above, too.
// CIE 147 has a rule for larger sources; no public source for it is known to us: they are refused.

#include "calc/base/field.h"
#include "calc/base/glare_limits.h"
#include "calc/radiosity/rays.h"
#include "calc/radiosity/receiver.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace calc {

// The field of sources that count: sideways up to this, upwards less than this, as multiples of the
// distance along the line of sight. At exactly 2 a source is out: the first row of the grid that
// UGR tables are made on lies there, and the example of CIE 190 holds without it.
inline constexpr double kWidestSource = 3.0, kHighestSource = 2.0;

// Up to where the table of CIE 117 has an index, with so much sideways (0 to 3): 1.7 below 0.4
// sideways, 1.8 below 0.9, else 1.9. From there to 2 there is the closed form only, and programs
// differ in whether sources count there: so in GlareSum they stand in `value` and `high`, and `low`
// has only those of their parts that are on the table.
double highest_on_table(double sideways);

inline constexpr std::size_t kSightLines = 16;

// Whether all of a luminaire's opening lies behind an eye, and so outside its field.
bool is_behind(const PlacedLuminaire& luminaire, const Receiver& eye);

// Guth's position index of a source at `to_source` (any length) from an eye that looks along the
// unit, horizontal direction `look`:
//   ln p = (35.2 - 0.31889 t - 1.22 exp(-2 t / 9)) 1e-3 s + (21 + 0.26667 t - 0.002963 t^2) 1e-5
//   s^2
// with s the angle between the source and the line of sight, t that between the vertical and the
// plane of both, in degrees.  [closed form of the IES Lighting Handbook; within 12 % of the table
// of CIE 117, and goes on above it] Empty outside the field above and for sources below the line of
// sight, for which there is no index.
std::optional<double> guth_index(const glm::dvec3& to_source, const glm::dvec3& look);

// What all luminaires send to one eye. sums: one per channel; refused: per channel, the first
// reason why the formula cannot be used for a source that this eye sees, see GlareField.
struct GlareSum {
  double value = 0.0, low = 0.0, high = 0.0;  // sum of L^2 w / p^2, cd^2 sr / m^4
  std::optional<GlareRefusal> refusal;
};
// receiver: planar, its axis the direction that the eye looks in. Returns the rays traced.
std::uint64_t add_glare_sources(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
                                std::span<GlareSum> channel_sums);

}  // namespace calc
