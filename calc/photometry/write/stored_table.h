#pragma once
// The other way round than web_assembly: from a web to the table that a photometry file stores.

#include "calc/base/diagnostics.h"
#include "calc/photometry/full_circle.h"
#include "calc/photometry/web.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Angles in degrees, rounded to 1e-9. circle_c_deg: every plane in [0, 360), ascending; {0} for an
// axial table. Planes that the symmetry needs (the images of the others, and 0, 90, 180, 270 where
// it has them) are put in by interpolation, which leaves the light unchanged.
struct StoredTable {
  PlaneSymmetry symmetry = PlaneSymmetry::none;  // that of the table, to kExactSymmetry
  std::vector<double> circle_c_deg;
  std::vector<double> gamma_deg;
  std::vector<double> intensity_cd;  // [plane of the circle][gamma]

  double cd(std::size_t plane, std::size_t gamma) const {
    return intensity_cd[plane * gamma_deg.size() + gamma];
  }
};

// The web itself if it is tabulated over C and gamma, else the same light resampled, with a warning
// of the steps and of what that changes. Empty, with an error, for a beam too narrow for that.
std::optional<PhotometricWeb> tabulated_over_c_gamma(const PhotometricWeb& web,
                                                     std::string_view format,
                                                     const std::string& name,
                                                     Diagnostics& diagnostics);

// web: tabulated over C and gamma. lowest_gamma: where the format wants tables to begin; they end
// at 90 or 180. A table that is dark at an end is led on to such an angle with zeros; one that is
// cut off in the light is kept as it is, with a warning. format, name: the target, for messages.
enum class LowestGamma { zero, zero_or_90 };
StoredTable make_stored_table(const PhotometricWeb& web, LowestGamma lowest_gamma,
                              std::string_view format, const std::string& name,
                              Diagnostics& diagnostics);

// Significant digits of intensities.
inline constexpr int kStoredDigits = 7;

// A decimal number without exponent and without zeros at its end: `digits` significant ones, but
// none finer than `decimals` places (0 to 15). value: finite, below 1e15.
std::string decimal_text(double value, int digits, int decimals);
// Places after the point that give `digits` significant ones at this value > 0.
int decimals_for(double value, int digits);

// Text of one line for a file in Windows-1252: what that cannot hold becomes '?'; lost is set then.
std::string file_line(std::string_view utf8, bool& lost);

}  // namespace calc
