#pragma once
// The sampling effort for openings, shared by the CPU (direct.cpp, opening_light.cpp) and devices
// (gpu/). These values change no mean, only its accuracy.

#include <cstddef>
#include <cstdint>

namespace calc {

// The error of n points of a scrambled net on a part is 0.8 diameter / distance * n^-1.5.
// [measured for a Lambertian panel at 45 degrees: within 35 % of that for 1 to 64 points and 1 to 8
// diameters]
inline constexpr double kCellError = 0.8;
inline constexpr double kCellWantedError = 0.005;

// Of two sides that are equal up to this factor, the first is halved, whatever the rounding.
inline constexpr double kAlikeSides = 1.0 - 1e-9;

// Samples of the rest, of all openings of a channel together, in each round of a replicate: enough
// to keep its error at that share of the known part.
inline constexpr double kRestWantedError = 0.003;
inline constexpr std::size_t kFewestRestSamples = 2, kMostRestSamples = 16;
// Root mean square of the rest over OpeningPatch::rest_lx().  [measured: 0.05 to 0.08]
inline constexpr double kMeanRest = 0.07;
// Sizes over distances up to which one place, or five, show how the light varies.
inline constexpr double kOnePlace = 0.01, kFivePlaces = 0.1;
// Floors of the rest, as shares of the luminaire's largest possible light and of the brightest
// place.
inline constexpr double kUnseenFloor = 1e-4, kPatchFloor = 1e-3;
// Larger parts are halved, because the rest grows with the third power.
inline constexpr double kLargestPatch = 0.7;

// Limits for beams that places so far apart might miss, in their half widths
// (WebSketch::finest_rad()): the largest size of parts, seen from the point; the sizes up to which
// one place and five are enough; and the unseen light as a share of the largest possible. CPU only
// (has_fine_beams()).
inline constexpr double kPartOfBeam = 2.0, kOnePlaceOfBeam = 0.2, kFivePlacesOfBeam = 0.8;
inline constexpr double kUnseenOfBeam = 0.02;

}  // namespace calc
