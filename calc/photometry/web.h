#pragma once
// A luminaire's far-field photometry: absolute luminous intensity over C-gamma.

#include "calc/photometry/lamp_tilt.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// The shape of the luminous opening, centred on the luminaire: flat across its axis, or a body. A
// disk and the bodies other than the box may be elliptical; cylinder: upright; cylinder_c0,
// cylinder_c90: with its axis along that line (a vertical disk is one of no length).
enum class OpeningShape {
  point,
  rectangle,
  disk,
  box,
  cylinder,
  cylinder_c0,
  cylinder_c90,
  ellipsoid
};

// along_c0_m: size along the C0-C180 axis, along_c90_m: along C90-C270. height_m of flat shapes is
// kept for reports.
struct LuminousOpening {
  OpeningShape shape = OpeningShape::point;
  double along_c0_m = 0.0;
  double along_c90_m = 0.0;
  double height_m = 0.0;

  bool is_body() const {
    switch (shape) {
      case OpeningShape::point:
      case OpeningShape::rectangle:
      case OpeningShape::disk:
        return false;
      case OpeningShape::box:
      case OpeningShape::cylinder:
      case OpeningShape::cylinder_c0:
      case OpeningShape::cylinder_c90:
      case OpeningShape::ellipsoid:
        break;
    }
    return true;
  }
  // Returns the size of the luminous shape along the luminaire's x, y and z.
  glm::dvec3 size_m() const {
    if (shape == OpeningShape::point) return glm::dvec3(0.0);
    return {along_c0_m, along_c90_m, is_body() ? height_m : 0.0};
  }
};

// The axis about which a table's planes turn, and from which gamma counts the angle.
enum class TableAxis {
  vertical,  // C-gamma as in the frame below
  // LM-63 type B: the line of C90. A direction (x, y, z) has the table angles that (-z, x, -y)
  // would have about the vertical: C = atan2(x, -z), gamma = acos(y) - so that nadir is C = 0,
  // gamma = 90.
  lateral
};

// The origin of the numbers, for reports. All text is UTF-8.
struct PhotometrySource {
  std::string format;          // "IESNA:LM-63-2002", "EULUMDAT", ...
  std::string luminaire_name;  // as the file states it; may be empty
  std::string manufacturer;    // may be empty
  double rated_lamp_flux_lm =
      0;                     // flux of all lamps as stated; 0 = absolute photometry or not stated
  double input_power_w = 0;  // 0 = not stated
  std::string power_rule{};  // words: whose power it is; "" = the photometry file's
  std::string
      applied_factors;  // words: "multiplier 1 x ballast 0.9", "LDT conversion 1 x 3000 lm / 1000"
  std::string axis_rule{};              // words: what C 0 and the opening's sides lie along
  std::optional<LampTilt> lamp_tilt{};  // the intensities hold its factor of tilt 0
  double stated_flux_lm = 0.0;          // of the luminaire, as the file states it; 0 = not stated
  // The share of the maximum at ends of the table beyond which the format allows more light, so
  // that the light there is unknown; 0 = it has no such end, or is dark there.
  double open_end_share = 0.0;
  // Texts as the file states them; "" = not stated.
  std::string article_number{}, lamp{}, colour_temperature{}, colour_rendering{};
  // The body's size along C0, along C90 and its height, all > 0; empty: not stated.
  std::optional<glm::dvec3> body_m{};
  bool body_is_round = false;  // seen along its axis
};

class LazyWebSketch;
class WebSketch;

// An intensity table over full circles, symmetric files already expanded; bilinear between entries
// (calc/CONVENTIONS.md, "Light"). Immutable after make(). Tables about another axis are kept, so
// that they are interpolated between the measured angles.
//
// Frame (calc/CONVENTIONS.md): x = C0, y = C90, gamma = 0 is -z, gamma = pi is +z;
// direction = (sin g cos C, sin g sin C, -cos g).
//
// At the poles of the table (nadir, zenith) C has no meaning and the planes of a good file agree.
// Where they do not, the value there is the mean over C, so that the rounding of a direction does
// not matter.
class PhotometricWeb {
 public:
  // Makes a web. c_rad: strictly ascending from 0 to 2 pi inclusive with the last plane equal to
  // the first, or {0} for a rotationally symmetric table. gamma_rad: strictly ascending within [0,
  // pi], at least 2 entries; outside the tabulated range intensity is 0. intensity_cd:
  // [plane][gamma], all >= 0 and finite, not all zero. Violations are bugs (readers check files
  // first): throws std::logic_error.
  static PhotometricWeb make(std::vector<double> c_rad, std::vector<double> gamma_rad,
                             std::vector<double> intensity_cd, LuminousOpening opening,
                             PhotometrySource source, TableAxis axis = TableAxis::vertical);

  // Returns the luminous intensity (cd) towards a unit direction in the luminaire's frame.
  double intensity_cd(const std::array<double, 3>& direction) const;
  // Returns the same by the angles of that frame, whatever the table's axis: c_rad any real
  // (wrapped), gamma_rad in [0, pi]. The first and last tabulated angle belong to the table, with
  // 1e-14 rad for the rounding of directions.
  double intensity_cd(double c_rad, double gamma_rad) const;

  // Returns the exact integral of the interpolated table over the sphere (lm), > 0.
  double flux_lm() const { return flux_lm_; }
  // Returns the same over the zone between two gamma angles, 0 <= from <= to <= pi. Exact about a
  // vertical axis; else by midpoints of half a degree.
  double zonal_flux_lm(double from_gamma_rad, double to_gamma_rad) const;
  double max_intensity_cd() const { return max_intensity_cd_; }

  // Returns the intensity by the table's own angles, else like intensity_cd().
  double at_table_angles_cd(double c_rad, double gamma_rad) const;

  // These give the table. Its angles are those of a direction turned into the table's frame.
  TableAxis axis() const { return axis_; }
  std::array<double, 3> to_table(const std::array<double, 3>& direction) const;
  std::array<double, 3> from_table(const std::array<double, 3>& direction) const;
  bool is_axial() const { return c_rad_.size() == 1; }
  const std::vector<double>& c_rad() const { return c_rad_; }
  const std::vector<double>& gamma_rad() const { return gamma_rad_; }
  double table_cd(std::size_t plane, std::size_t gamma) const {
    return intensity_cd_[plane * gamma_rad_.size() + gamma];
  }
  const LuminousOpening& opening() const { return opening_; }
  const PhotometrySource& source() const { return source_; }
  // Returns a sketch for many directions at once, made on the first call, by any thread.
  const WebSketch& sketch() const;

 private:
  PhotometricWeb() = default;

  double table_zone_lm(double from_gamma_rad, double to_gamma_rad) const;
  double mean_over_c_cd(std::size_t gamma) const;
  double interpolate_gamma_cd(std::size_t plane, std::size_t gamma, double fraction) const;

  TableAxis axis_ = TableAxis::vertical;
  std::vector<double> c_rad_, gamma_rad_, intensity_cd_;
  LuminousOpening opening_;
  PhotometrySource source_;
  double flux_lm_ = 0.0;
  double max_intensity_cd_ = 0.0;
  double nadir_cd_ = 0.0, zenith_cd_ = 0.0;  // 0 where the table does not reach the pole
  std::shared_ptr<LazyWebSketch> sketch_;    // of copies, too
};

// C in [0, 2 pi] and gamma in [0, pi] of a direction; C = 0 at the poles.
struct WebAngles {
  double c_rad, gamma_rad;
};
WebAngles angles_of(const std::array<double, 3>& direction);
std::array<double, 3> direction_of(const WebAngles& angles);

// Returns the index i of the interval [nodes[i], nodes[i + 1]] that holds x; the first or last
// interval when x is outside. nodes: ascending, at least 2.
std::size_t interval_of(const std::vector<double>& nodes, double x);

}  // namespace calc
