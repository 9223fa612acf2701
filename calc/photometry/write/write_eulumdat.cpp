#include "calc/photometry/write/write_eulumdat.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/photometry/read/ies_opening.h"
#include "calc/photometry/web_measures.h"
#include "calc/photometry/write/stored_table.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace calc {
namespace {

constexpr std::size_t kTextLength = 78;  // as the format's description limits texts
constexpr std::size_t kMostPlanes = 360, kMostGammaAngles = 361;
constexpr double kLinearAspect = 2.5;   // openings this long count as linear luminaires
constexpr double kThinnest_m = 1.0e-6;  // a width of 0 would mean a circle
constexpr double kSameDiameter_m = 0.5e-6;

class EulumdatWriter {
 public:
  EulumdatWriter(const PhotometricWeb& web, const StoredTable& table, const std::string& name,
                 Diagnostics& diagnostics)
      : web_(web), table_(table), name_(name), diagnostics_(diagnostics) {
    isym_ = isym();
    set_flux_lm_ = web.source().rated_lamp_flux_lm;
    if (!(set_flux_lm_ > 0.0)) {  // a number that reads back as it is used here
      set_flux_lm_ = *parse_number(decimal_text(web.flux_lm(), 9, 12));
    }
  }

  std::string write() {
    warn_of_counts();
    add_head();
    add_opening();
    add_lamps();
    for (const double c : table_.circle_c_deg) number(c);
    for (const double gamma : table_.gamma_deg) number(gamma);
    add_intensities();
    return text_;
  }

 private:
  SourceLocation file() const { return {name_, 0, 0}; }
  void line(const std::string& words) { text_ += words + "\r\n"; }
  void number(double value) { line(decimal_text(value, 15, 9)); }

  // Readers tell formats and encodings by how a line begins.
  static bool begins_misleadingly(std::string_view line) {
    return trim(line).starts_with("TILT=") || has_utf16_mark(line) ||
           without_byte_order_mark(line) != line;
  }

  void text_line(const std::string& utf8) {
    bool changed = utf8.size() > kTextLength;
    std::string text = file_line(utf8, changed);
    if (begins_misleadingly(text)) {
      text.insert(0, "_");
      changed = true;
    }
    line(text.substr(0, kTextLength));
    if (changed) {
      diagnostics_.report(DiagnosticId::photometry_write_text, file(), utf8, "EULUMDAT");
    }
  }

  // Planes C270 .. C90 are found by count (3/4 Mc) in many readers: planes that do not stand so are
  // written in full.
  int isym() const {
    const std::vector<double>& c = table_.circle_c_deg;
    switch (table_.symmetry) {
      case PlaneSymmetry::axial:
        return 1;
      case PlaneSymmetry::c0_c180:
        return 2;
      case PlaneSymmetry::c90_c270:
        return c.size() % 4 == 0 && c[c.size() / 4] == 90.0 && c[3 * c.size() / 4] == 270.0 ? 3 : 0;
      case PlaneSymmetry::quadrant:
        return 4;
      case PlaneSymmetry::none:
        break;
    }
    return 0;
  }

  void warn_of_counts() {
    const auto warn = [&](const char* what, std::size_t count, std::size_t most) {
      if (count <= most) return;
      diagnostics_.report(DiagnosticId::photometry_write_count, file(), count, what, most);
    };
    warn("C-planes", table_.circle_c_deg.size(), kMostPlanes);
    warn("gamma angles", table_.gamma_deg.size(), kMostGammaAngles);
  }

  // 0 for irregular steps, and for a single angle.
  static double step_of(const std::vector<double>& angles) {
    if (angles.size() < 2) return 0.0;
    const double step = angles[1] - angles[0];
    for (std::size_t i = 1; i < angles.size(); ++i) {
      if (std::abs(angles[i] - angles[i - 1] - step) > 1.0e-8) return 0.0;
    }
    return step;
  }

  void add_head() {
    const PhotometrySource& source = web_.source();
    const LuminousOpening& opening = web_.opening();
    const double longer = std::max(opening.along_c0_m, opening.along_c90_m);
    const double shorter = std::min(opening.along_c0_m, opening.along_c90_m);
    const bool is_linear = longer > 0.0 && longer >= kLinearAspect * shorter;
    text_line(source.manufacturer);
    number(isym_ == 1 ? 1 : is_linear ? 2 : 3);
    number(isym_);
    number(static_cast<double>(table_.circle_c_deg.size()));
    number(step_of(table_.circle_c_deg));
    number(static_cast<double>(table_.gamma_deg.size()));
    number(step_of(table_.gamma_deg));
    text_line(source.format.empty() ? "converted by luxgate"
                                    : "converted by luxgate from " + source.format);
    text_line(source.luminaire_name);
    for (int i = 0; i < 3; ++i) line("");  // luminaire number, file name, date
  }

  void add_opening() {
    const LuminousOpening& opening = web_.opening();
    double length_m = opening.along_c90_m;
    double width_m = opening.along_c0_m;
    double height_m = opening.height_m;
    const auto warn = [&](const char* what) {
      diagnostics_.report(DiagnosticId::photometry_write_opening, file(), "EULUMDAT", what);
    };
    const bool is_circle = std::abs(length_m - width_m) <= kSameDiameter_m;
    bool is_written_round = false;
    switch (opening.shape) {
      case OpeningShape::point:
        length_m = width_m = height_m = 0.0;
        break;
      case OpeningShape::disk:
        is_written_round = is_circle;
        if (!is_circle) warn("an ellipse: it is written as the rectangle around it");
        break;
      case OpeningShape::cylinder:
        is_written_round = is_circle;
        if (!is_circle) warn("an elliptical cylinder: it is written as the box around it");
        break;
      case OpeningShape::ellipsoid:
        is_written_round = is_circle;
        warn(is_circle ? "a sphere or ellipsoid: it is written as the upright cylinder around it"
                       : "an ellipsoid: it is written as the box around it");
        break;
      case OpeningShape::cylinder_c0:
      case OpeningShape::cylinder_c90:
        warn("a lying cylinder: it is written as the box around it");
        break;
      case OpeningShape::rectangle:
      case OpeningShape::box:
        break;
    }
    // With its height it would read as a box or a cylinder.
    if (!opening.is_body() && !is_flat_enough(length_m, width_m, height_m)) {
      warn("a flat opening with a height of more than a tenth of its size: the height is left out");
      height_m = 0.0;
    }
    if (is_written_round) {
      width_m = 0.0;
    } else if (width_m == 0.0 && length_m > 0.0) {
      warn("a width of 0, which would mean a circle: it is written as 0.001 mm");
      width_m = kThinnest_m;
    }
    const auto millimetres = [&](double metres) { number(metres / kMetresPerMillimetre); };
    millimetres(length_m);  // of the housing
    millimetres(width_m);
    millimetres(height_m);
    millimetres(length_m);  // of the luminous area
    millimetres(width_m);
    for (int side = 0; side < 4; ++side) millimetres(height_m);
  }

  void add_lamps() {
    const bool is_absolute = !(web_.source().rated_lamp_flux_lm > 0.0);
    line(decimal_text(100.0 * downward_share(web_), 15, 2));
    line(is_absolute ? "100" : decimal_text(100.0 * web_.flux_lm() / set_flux_lm_, 15, 2));
    line("1");  // conversion factor
    line("0");  // tilt
    line("1");  // lamp sets
    line(is_absolute ? "-1" : "1");
    line("not stated");
    number(set_flux_lm_);
    line("");
    line("");
    number(web_.source().input_power_w);
    for (int i = 0; i < 10; ++i) line("0");  // direct ratios
  }

  void add_intensities() {
    const double klm = set_flux_lm_ / 1000.0;
    const int decimals = decimals_for(web_.max_intensity_cd() / klm, 11);
    const std::size_t count = table_.circle_c_deg.size();
    std::size_t first = 0;
    std::size_t planes = count;
    if (isym_ == 2) planes = count / 2 + 1;
    if (isym_ == 4) planes = count / 4 + 1;
    if (isym_ == 3) {
      first = 3 * count / 4;
      planes = count / 2 + 1;
    }
    for (std::size_t i = 0; i < planes; ++i) {
      for (std::size_t g = 0; g < table_.gamma_deg.size(); ++g) {
        line(decimal_text(table_.cd((first + i) % count, g) / klm, kStoredDigits, decimals));
      }
    }
  }

  const PhotometricWeb& web_;
  const StoredTable& table_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  int isym_ = 0;
  double set_flux_lm_ = 0.0;
  std::string text_;
};

// EULUMDAT does not list C 360, so that a last step wider than all others looks like missing planes
// (full_circle()). One more plane, between the last and the first, leaves the light unchanged.
void narrow_last_step(StoredTable& table) {
  constexpr double kMost_deg = 90.0;
  std::vector<double>& c_deg = table.circle_c_deg;
  if (table.symmetry != PlaneSymmetry::none) return;
  double widest = 0.0;
  for (std::size_t i = 1; i < c_deg.size(); ++i) widest = std::max(widest, c_deg[i] - c_deg[i - 1]);
  const double last = c_deg.back();
  const double step = std::min(widest, kMost_deg);
  if (360.0 - last <= step) return;
  const double share = (360.0 - step - last) / (360.0 - last);
  for (std::size_t g = 0; g < table.gamma_deg.size(); ++g) {
    table.intensity_cd.push_back(std::lerp(table.cd(c_deg.size() - 1, g), table.cd(0, g), share));
  }
  c_deg.push_back(360.0 - step);
}

}  // namespace

std::optional<std::string> write_eulumdat(const PhotometricWeb& web, const std::string& name,
                                          Diagnostics& diagnostics) {
  const std::optional<PhotometricWeb> tabulated =
      tabulated_over_c_gamma(web, "EULUMDAT", name, diagnostics);
  if (!tabulated) return std::nullopt;
  StoredTable table =
      make_stored_table(*tabulated, LowestGamma::zero, "EULUMDAT", name, diagnostics);
  narrow_last_step(table);
  return EulumdatWriter(*tabulated, table, name, diagnostics).write();
}

}  // namespace calc
