#pragma once
// The limits within which CIE 117 and CIE 147 state UGR: judged by rules, calculated by
// calc/radiosity/direct/glare.h.

namespace calc {

// A source of a larger solid angle is too large for the formula, sr.  [CIE 117]
inline constexpr double kLargestGlareSource_sr = 0.1;

// For a source of a smaller area, as the eye sees it, the formula is too severe: such a source
// counts as one of this area with the same intensity, m2.  [CIE 147]
inline constexpr double kSmallestGlareSource_m2 = 0.005;

// A source of a larger area is too large for the formula, wherever it is, m2.  [CIE 147]
inline constexpr double kLargestGlareSource_m2 = 1.5;

// Einhorn's formula for luminous ceilings is  8 log10( 2 (1 + E_d / 220) / (E_d + E_i)  sum L^2 w /
// p^2 )  with the direct and the reflected illuminance of the eye; CIE 55 has 500 lx instead of
// 220. It is monotonic in E_d, so that max(1 / E_i, 1 / 220) instead of the fraction is an upper
// bound.
inline constexpr double kLuminousCeiling_lx = 220.0;

// The largest difference between the table of position indices and the closed form, in UGR.
inline constexpr double kTableOfIndicesDiffers = 0.8;

}  // namespace calc
