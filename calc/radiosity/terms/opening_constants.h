#pragma once
// How much work an opening is worth: what the CPU (direct.cpp, opening_light.cpp) and devices
// (gpu/) both go by. None of these decides what a mean is, only how well it is known.

#include <cstddef>
#include <cstdint>

namespace calc {

// n points of a scrambled net on a part are off by 0.8 diameter / distance * n^-1.5.  [measured for
// a Lambertian panel at 45 degrees: within 35 % of that for 1 to 64 points and 1 to 8 diameters]
inline constexpr double kCellError = 0.8;
inline constexpr double kCellWantedError = 0.005;

// Of two sides as long as each other but for this, the first is halved, whatever rounding says.
inline constexpr double kAlikeSides = 1.0 - 1e-9;

// Samples of the rest, of all openings of a channel together, in each round of a replicate: as many
// as keep its error at that share of what is known.
inline constexpr double kRestWantedError = 0.003;
inline constexpr std::size_t kFewestRestSamples = 2, kMostRestSamples = 16;
// Root mean square of the rest over OpeningPatch::rest_lx().  [measured: 0.05 to 0.08]
inline constexpr double kMeanRest = 0.07;
// Sizes over distances up to which one place, five places, tell enough of how the light varies.
inline constexpr double kOnePlace = 0.01, kFivePlaces = 0.1;
// Share of what the luminaire could send at most that the rest is never taken to be below, and of
// the brightest place.
inline constexpr double kUnseenFloor = 1e-4, kPatchFloor = 1e-3;
// Larger parts are halved: the rest falls with the third power.
inline constexpr double kLargestPatch = 0.7;

// Of beams that places so far apart might miss, in their half widths (WebSketch::finest_rad()):
// parts are no larger, seen from the point, than the first; up to the others one place and five
// tell enough; and what is not seen may be that share of the most that could be. The CPU alone
// (has_fine_beams()).
inline constexpr double kPartOfBeam = 2.0, kOnePlaceOfBeam = 0.2, kFivePlacesOfBeam = 0.8;
inline constexpr double kUnseenOfBeam = 0.02;

}  // namespace calc
