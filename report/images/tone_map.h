#pragma once
// Luminance as shades of a screen, for rendered views: Reinhard's global operator with a white
// point, in warm grey. [Reinhard02]

#include "report/images/room_picture.h"

#include <span>

namespace report {

// The logarithmic average of luminances, cd/m2; values below 0 are nothing and left out. What is
// darker than 0.001 counts as that: a black corner must not decide. 0 of none.
double log_average(std::span<const float> cd_m2);

// average: of the picture, cd/m2. It becomes a middle grey, sixteen times as much white.
Rgb toned(double cd_m2, double average);
// The same for paint_room(), in steps that are too small to be seen.
Palette tone_palette(double average);

}  // namespace report
