#pragma once
// Computes the sum over luminaires that an eye sees for the unified glare rating.
//
//   UGR = 8 log10( 0.25 / Lb  sum L^2 w / p^2 ),  Lb = E_ind / pi     [CIE 117]
//
// The sum, of the direct light, has no noise. E_ind, the illuminance of the eye by reflected light
// only, is sampled like every other (DerivedQuantity::ugr); rules/measure/derived_points.h joins
// them.
//
// L = I / A: luminous intensity towards the eye over the opening's area as seen from there; w = A /
// r^2, r to the opening's centre; both as for an eye far away, of the whole opening. The index p is
// that of the centre. If the centre is outside the field but parts of the opening are on the table
// of indices, each of them counts with its own. For a partly hidden opening L stays and w is the
// visible share, counted on kSightLines^2 lines of sight spread evenly over the opening; one
// straight edge across it then causes an error of at most 1 / kSightLines of the opening.
//
// A source of more than 0.1 sr is too large for the formula. At most its visible part in the field
// counts. Each visible part in the field is a source of its own, with its own L, w and p, and `low`
// and `high` also include its value by the rule above. If that part is also more than 0.1 sr, it is
// in the doubts: for such a source the formula is too mild  [CIE 147], and the reader of the sum
// must add the possible excess (kLuminousCeiling_lx).
//
// Where else the formula is not stated, `low` and `high` hold both possible meanings, and the
// doubts say so. Below the line of sight there is no index: parts of a source there count only in
// `high`, with Iwata's. A source of less than 0.005 m2, as seen from there, counts as one of that
// area in `low`  [CIE 147] and unchanged in `value` and `high`. A source without area counts as one
// of 0.005 m2 in `value` and `high`, and not at all in `low`.

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

// Returns whether all of a luminaire's opening is behind an eye, and so outside its field.
bool is_behind(const PlacedLuminaire& luminaire, const Receiver& eye);

// Glare from all luminaires of a channel at one eye.
struct GlareSum {
  double value = 0.0, low = 0.0, high = 0.0;  // sum of L^2 w / p^2, cd^2 sr / m^4
  std::vector<GlareDoubt> doubts;             // of every problem the first one, see GlareField
};
// Adds to the sums and returns the rays traced. receiver: planar, its axis the direction of view.
// joined: joined_luminaires() of the scene.
std::uint64_t add_glare_sources(const Tracer& tracer, const Receiver& receiver, bool has_shadows,
                                std::span<const JoinedOpening> joined,
                                std::span<GlareSum> channel_sums);

// Returns luminaires whose openings touch, by their places in the scene: where an eye sees more
// than 0.1 sr of them, they are too large a source, whatever the size of each.
std::vector<JoinedOpening> joined_luminaires(const PreparedScene& scene);

}  // namespace calc
