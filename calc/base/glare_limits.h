#pragma once
// What CIE 117 states UGR for: judged by rules, calculated by calc/radiosity/glare.h.

namespace calc {

// The range of solid angles of a source that the formula is stated for, sr.
inline constexpr double kSmallestGlareSource_sr = 3.0e-4;
inline constexpr double kLargestGlareSource_sr = 0.1;

// By how much the table of position indices can differ from the closed form, in UGR.
inline constexpr double kTableOfIndicesDiffers = 0.8;

}  // namespace calc
