#pragma once
// A luminaire's far-field photometry: absolute luminous intensity over C-gamma.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace calc {

// Shape of the luminous opening, centred on the luminaire, in the plane across its axis.
enum class OpeningShape { point, rectangle, disk };

// along_c0_m: size along the C0-C180 axis, along_c90_m: along C90-C270; a disk (or ellipse) uses
// them as its two diameters. A file's height (luminous sides) is kept for reports; light leaves the
// opening plane.
struct LuminousOpening {
  OpeningShape shape = OpeningShape::point;
  double along_c0_m = 0.0;
  double along_c90_m = 0.0;
  double height_m = 0.0;
};

// Where the numbers came from, for reports. All text is UTF-8.
struct PhotometrySource {
  std::string format;          // "IESNA:LM-63-2002", "EULUMDAT", ...
  std::string luminaire_name;  // as the file states it; may be empty
  std::string manufacturer;    // may be empty
  double rated_lamp_flux_lm =
      0;                     // flux of all lamps as stated; 0 = absolute photometry or not stated
  double input_power_w = 0;  // 0 = not stated
  std::string
      applied_factors;  // words: "multiplier 1 x ballast 0.9", "LDT conversion 1 x 3000 lm / 1000"
};

// Intensity table over full circles, symmetric files already expanded; bilinear between entries
// [PHOTO: bilinear in angle]. Immutable after make().
//
// Frame (calc/CONVENTIONS.md): x = C0, y = C90, gamma = 0 is -z, gamma = pi is +z;
// direction = (sin g cos C, sin g sin C, -cos g).
//
// At the poles (nadir, zenith) C has no meaning and the planes of a good file agree. Where they do
// not, the value there is the mean over C, so that it does not depend on how a direction was
// rounded.
class PhotometricWeb {
 public:
  // c_rad: strictly ascending from 0 to 2 pi inclusive with the last plane equal to the first, or
  // {0} for a rotationally symmetric table. gamma_rad: strictly ascending within [0, pi], at least
  // 2 entries; outside the tabulated range intensity is 0. intensity_cd: [plane][gamma], all >= 0
  // and finite, not all zero. Violations are our own mistakes (readers check files first): throws
  // std::logic_error.
  static PhotometricWeb make(std::vector<double> c_rad, std::vector<double> gamma_rad,
                             std::vector<double> intensity_cd, LuminousOpening opening,
                             PhotometrySource source);

  // Luminous intensity (cd) towards a unit direction in the luminaire's frame.
  double intensity_cd(const std::array<double, 3>& direction) const;
  // The same by angles: c_rad any real (wrapped), gamma_rad in [0, pi]. The first and last
  // tabulated angle belong to the table, with 1e-14 rad for the rounding of directions.
  double intensity_cd(double c_rad, double gamma_rad) const;

  // Exact integral of the interpolated table over the sphere (lm), > 0.
  double flux_lm() const { return flux_lm_; }
  // The same over the zone between two gamma angles, 0 <= from <= to <= pi.
  double zonal_flux_lm(double from_gamma_rad, double to_gamma_rad) const;
  double max_intensity_cd() const { return max_intensity_cd_; }

  bool is_axial() const { return c_rad_.size() == 1; }
  const std::vector<double>& c_rad() const { return c_rad_; }
  const std::vector<double>& gamma_rad() const { return gamma_rad_; }
  double table_cd(std::size_t plane, std::size_t gamma) const {
    return intensity_cd_[plane * gamma_rad_.size() + gamma];
  }
  const LuminousOpening& opening() const { return opening_; }
  const PhotometrySource& source() const { return source_; }

 private:
  PhotometricWeb() = default;

  double mean_over_c_cd(std::size_t gamma) const;
  double interpolate_gamma_cd(std::size_t plane, std::size_t gamma, double fraction) const;

  std::vector<double> c_rad_, gamma_rad_, intensity_cd_;
  LuminousOpening opening_;
  PhotometrySource source_;
  double flux_lm_ = 0.0;
  double max_intensity_cd_ = 0.0;
  double nadir_cd_ = 0.0, zenith_cd_ = 0.0;  // 0 where the table does not reach the pole
};

// C in [0, 2 pi] and gamma in [0, pi] of a direction; C = 0 at the poles.
struct WebAngles {
  double c_rad, gamma_rad;
};
WebAngles angles_of(const std::array<double, 3>& direction);

// Index i of the interval [nodes[i], nodes[i + 1]] that holds x; the first or last interval when x
// lies outside. nodes: ascending, at least 2.
std::size_t interval_of(const std::vector<double>& nodes, double x);

}  // namespace calc
