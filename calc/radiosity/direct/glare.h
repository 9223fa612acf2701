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
// the field, at most. Each seen part in the field counts as a source of its own, with its own L, w
// and p, and `low` and `high` hold what it would count as above, too. If that is more than 0.1 sr,
// too, it stands in the doubts: for such a source the formula is too mild  [CIE 147], and what it
// may count beyond is for the reader of the sum to add (kLuminousCeiling_lx).
//
// Where else the formula is not stated, `low` and `high` hold both ways that it may be meant, and
// the doubts say so. Below the line of sight there is no index: what of a source lies there counts
// in `high` alone, with Iwata's. A source of less than 0.005 m2, as seen from there, counts as one
// of that area in `low`  [CIE 147] and as it is in `value` and `high`. One without any area counts
// as one of 0.005 m2 in `value` and `high`, and in `low` not at all.

#include "calc/base/field.h"
#include "calc/base/glare_limits.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/scene/joined_openings.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace calc {

inline constexpr std::size_t kSightLines = 16;

// Whether all of a luminaire's opening lies behind an eye, and so outside its field.
bool is_behind(const PlacedLuminaire& luminaire, const Receiver& eye);

// What all luminaires of a channel send to one eye.
struct GlareSum {
  double value = 0.0, low = 0.0, high = 0.0;  // sum of L^2 w / p^2, cd^2 sr / m^4
  std::vector<GlareDoubt> doubts;             // of every problem the first one, see GlareField
};
// receiver: planar, its axis the direction that the eye looks in. Returns the rays traced.
// joined: joined_luminaires() of the scene.
std::uint64_t add_glare_sources(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
                                std::span<const JoinedOpening> joined,
                                std::span<GlareSum> channel_sums);

// Luminaires whose openings touch, by their places in the scene: where what an eye sees of them is
// more than 0.1 sr, they are a source too large, whatever each of them is.
std::vector<JoinedOpening> joined_luminaires(const PreparedScene& scene);

}  // namespace calc
