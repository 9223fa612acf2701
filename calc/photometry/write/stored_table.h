#pragma once
// Makes from a web the table that a photometry file stores, the reverse of web_assembly.

#include "calc/base/diagnostics.h"
#include "calc/photometry/full_circle.h"
#include "calc/photometry/web.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// The table: angles in degrees, rounded to 1e-9. circle_c_deg: every plane in [0, 360), ascending;
// {0} for an axial table. Planes that the symmetry needs (mirror images of the others, and its
// planes among 0, 90, 180, 270) are interpolated, which leaves the light unchanged.
struct StoredTable {
  PlaneSymmetry symmetry = PlaneSymmetry::none;  // that of the table, to kExactSymmetry
  std::vector<double> circle_c_deg;
  std::vector<double> gamma_deg;
  std::vector<double> intensity_cd;  // [plane of the circle][gamma]

  double cd(std::size_t plane, std::size_t gamma) const {
    return intensity_cd[plane * gamma_deg.size() + gamma];
  }
};

// Returns the web itself if it is tabulated over C and gamma, else the same light resampled, with a
// warning of the steps and the difference. Empty, with an error, for a beam too narrow for that.
std::optional<PhotometricWeb> tabulated_over_c_gamma(const PhotometricWeb& web,
                                                     std::string_view format,
                                                     const std::string& name,
                                                     Diagnostics& diagnostics);

// Makes the table of a web tabulated over C and gamma. lowest_gamma: where the format's tables
// begin; they end at 90 or 180. A table that is dark at an end is continued to such an angle with
// zeros; a table cut off in the light is kept, with a warning. format, name: the target, for
// messages.
enum class LowestGamma { zero, zero_or_90 };
StoredTable make_stored_table(const PhotometricWeb& web, LowestGamma lowest_gamma,
                              std::string_view format, const std::string& name,
                              Diagnostics& diagnostics);

// Significant digits of intensities.
inline constexpr int kStoredDigits = 7;

// Returns a decimal number without exponent and trailing zeros: `digits` significant ones, at most
// `decimals` places (0 to 15). value: finite, below 1e15.
std::string decimal_text(double value, int digits, int decimals);
// Returns the places after the point for `digits` significant digits of this value > 0.
int decimals_for(double value, int digits);

// Returns a line in Windows-1252: other characters become '?' and set `lost`.
std::string file_line(std::string_view utf8, bool& lost);

}  // namespace calc
