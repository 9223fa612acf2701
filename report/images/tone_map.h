#pragma once
// Luminance as shades of a screen, for rendered views: Reinhard's global operator with a white
// point, in warm grey. [Reinhard02]

#include "report/images/room_picture.h"

#include <span>

namespace report {

// Returns the logarithmic average of luminances, cd/m2, without values below 0, which mean no
// surface. Values below 0.001 count as 0.001, so that a black corner does not dominate. 0 if there
// are none.
double log_average(std::span<const float> cd_m2);

// Returns the shade. average: of the picture, cd/m2; it becomes a middle grey, sixteen times as
// much white.
Rgb toned(double cd_m2, double average);
// Returns the shades for paint_room(), in steps that are too small to be seen.
Palette tone_palette(double average);

}  // namespace report
