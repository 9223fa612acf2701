#pragma once
// The table of unified glare ratings of one type of luminaire in rooms of standard shape: how
// makers state glare, for a regular array of it.  [CIE 117; CIE 190]
//
// A room is X (across the line of sight) by Y (along it), in multiples of H, the height of the
// luminaires above the eye. The eye is in the middle of a wall that is X long and looks along Y;
// luminaires stand at half a spacing from the walls. UGR is that of glare.h:
//   - every source counts as for an eye far away, by the closed form of the position index;
//   - an opening counts with its sides (mean_luminance.h);
//   - L_b = E_w / pi with E_w the mean indirect illuminance of the walls, by the exact exchange of
//     light between three surfaces: the walls, the luminaires' plane (ceiling) and the eye's plane
//     (floor). That is the method's own choice: at an eye it is another one, and such a table is no
//     substitute for it.
// H drops out. Against tables of three luminaires by other programs this is within 0.4 of Relux and
// 0.8 of DIALux, which differ by as much from each other: tests/unit/calc/radiosity/ugr_table_test.

#include "calc/photometry/web.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace calc {

struct UgrReflectances {
  double ceiling, walls, floor;
};
inline constexpr std::array<UgrReflectances, 5> kUgrReflectances{
    {{0.7, 0.5, 0.2}, {0.7, 0.3, 0.2}, {0.5, 0.5, 0.2}, {0.5, 0.3, 0.2}, {0.3, 0.3, 0.2}}};

// How the eye looks at the luminaires: along their C0-C180 (across the longer side of most), or
// along C90-C270.
enum class UgrView : std::size_t { crosswise, endwise };
inline constexpr std::size_t kUgrViews = 2;

struct UgrRow {
  double x_per_h = 0.0, y_per_h = 0.0;
  // [view][reflectances]; not a number where no luminaire is in the field of view with an area.
  std::array<std::array<double, kUgrReflectances.size()>, kUgrViews> ugr{};
};

// The 19 rooms of such tables, by X, then Y; values for the flux of the web. spacing_per_h: of the
// luminaires, in (0, 2]; programs take 0.25, CIE 190's own example 1. Empty: the opening has no
// area, so that there is no luminance.
std::optional<std::vector<UgrRow>> ugr_table(const PhotometricWeb& web,
                                             double spacing_per_h = 0.25);

// What data sheets state: X = 4 H, Y = 8 H, reflectances 0.7, 0.5 and 0.2.
const UgrRow& ugr_reference_row(const std::vector<UgrRow>& table);

// Share of the light from one of two equal, opposite rectangles X by Y at the distance 1 that
// reaches the other.  [closed form, e.g. Howell, C-11]
double opposite_rectangles_share(double x, double y);

}  // namespace calc
