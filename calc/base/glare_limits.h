#pragma once
// What CIE 117 and CIE 147 state UGR for: judged by rules, calculated by
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
// p^2 )  with the direct and the reflected illuminance of the eye; CIE 55 has it with 500 lx in the
// place of 220. It grows or falls with E_d all the way, so that it is never more than with
// max(1 / E_i, 1 / 220) in the place of the fraction.
inline constexpr double kLuminousCeiling_lx = 220.0;

// By how much the table of position indices can differ from the closed form, in UGR.
inline constexpr double kTableOfIndicesDiffers = 0.8;

}  // namespace calc
