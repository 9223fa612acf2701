#include "calc/photometry/write/write_lm63.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/photometry/read/ies_opening.h"
#include "calc/photometry/write/stored_table.h"

#include <algorithm>
#include <vector>

namespace calc {
namespace {

constexpr const char* kLineEnd = "\r\n";
constexpr std::size_t kLineLength = 100;     // 256 are allowed in 2002, 132 before
constexpr std::size_t kKeywordLength = 200;  // characters of text

std::string numbers_text(const std::vector<double>& values, int digits, int decimals) {
  std::string text;
  std::size_t used = 0;
  for (const double value : values) {
    const std::string word = decimal_text(value, digits, decimals);
    if (used > 0) {
      const bool fits = used + 1 + word.size() <= kLineLength;
      text += fits ? " " : kLineEnd;
      used = fits ? used + 1 : 0;
    }
    text += word;
    used += word.size();
  }
  return text + kLineEnd;
}

std::string keyword(const char* name, const std::string& utf8, const std::string& file,
                    Diagnostics& diagnostics) {
  bool changed = utf8.size() > kKeywordLength;
  const std::string text = file_line(utf8, changed).substr(0, kKeywordLength);
  if (changed) {
    diagnostics.report(DiagnosticId::photometry_write_text, SourceLocation{file, 0, 0}, utf8,
                       "LM-63");
  }
  return fmt::format("[{}] {}{}", name, text, kLineEnd);
}

// The code table of LM-63-2002: signs tell the shapes apart. Width lies along C90, length along C0.
std::string opening_text(const LuminousOpening& opening, const SourceLocation& file,
                         Diagnostics& diagnostics) {
  double width = opening.along_c90_m, length = opening.along_c0_m, height = opening.height_m;
  const auto warn = [&](const char* what) {
    diagnostics.report(DiagnosticId::photometry_write_opening, file, "LM-63", what);
  };
  switch (opening.shape) {
    case OpeningShape::point:
      return "0 0 0";
    case OpeningShape::rectangle:
    case OpeningShape::disk:
      // With its height it would read as a box or a cylinder.
      if (!is_flat_enough(length, width, height)) {
        warn(
            "a flat opening with a height of more than a tenth of its size: the height is left "
            "out");
        height = 0.0;
      }
      break;
    case OpeningShape::cylinder_c90:
      if (width == 0.0) warn("a vertical disk that faces C 90: it is written as the box around it");
      break;
    default:
      break;
  }
  const bool is_round = opening.shape == OpeningShape::disk ||
                        opening.shape == OpeningShape::cylinder ||
                        opening.shape == OpeningShape::ellipsoid;
  const bool is_lying_along_c0 = opening.shape == OpeningShape::cylinder_c0;
  const bool is_lying_along_c90 = opening.shape == OpeningShape::cylinder_c90 && width > 0.0;
  if (is_round || is_lying_along_c0) width = -width;
  if (is_round || is_lying_along_c90) length = -length;
  if (is_lying_along_c0 || is_lying_along_c90 || opening.shape == OpeningShape::ellipsoid) {
    height = -height;
  }
  const auto metres = [](double value) { return decimal_text(value, 15, 6); };
  return fmt::format("{} {} {}", metres(width), metres(length), metres(height));
}

// The planes that are written, as positions on the circle; its size stands for C 360.
std::vector<std::size_t> written_planes(const StoredTable& table) {
  double last_deg = 360.0;
  if (table.symmetry == PlaneSymmetry::axial) last_deg = 0.0;
  if (table.symmetry == PlaneSymmetry::quadrant) last_deg = 90.0;
  if (table.symmetry == PlaneSymmetry::c0_c180) last_deg = 180.0;
  std::vector<std::size_t> planes;
  for (std::size_t p = 0; p < table.circle_c_deg.size(); ++p) {
    if (table.circle_c_deg[p] <= last_deg) planes.push_back(p);
  }
  if (last_deg == 360.0) planes.push_back(table.circle_c_deg.size());
  return planes;
}

std::string table_text(const StoredTable& table, double highest_cd) {
  const std::vector<std::size_t> planes = written_planes(table);
  std::vector<double> c_deg;
  for (const std::size_t p : planes) {
    c_deg.push_back(p < table.circle_c_deg.size() ? table.circle_c_deg[p] : 360.0);
  }
  std::string text = numbers_text(table.gamma_deg, 15, 9) + numbers_text(c_deg, 15, 9);
  const int decimals = decimals_for(highest_cd, 11);
  for (const std::size_t p : planes) {
    std::vector<double> values;
    for (std::size_t g = 0; g < table.gamma_deg.size(); ++g) {
      values.push_back(table.cd(p % table.circle_c_deg.size(), g));
    }
    text += numbers_text(values, kStoredDigits, decimals);
  }
  return text;
}

}  // namespace

std::optional<std::string> write_lm63(const PhotometricWeb& any_web, const std::string& name,
                                      Diagnostics& diagnostics) {
  const std::optional<PhotometricWeb> web =
      tabulated_over_c_gamma(any_web, "LM-63", name, diagnostics);
  if (!web) return std::nullopt;
  const StoredTable table =
      make_stored_table(*web, LowestGamma::zero_or_90, "LM-63", name, diagnostics);
  const PhotometrySource& source = web->source();
  const auto add = [&](const char* key, const std::string& utf8) {
    return keyword(key, utf8, name, diagnostics);
  };
  std::string text = std::string("IESNA:LM-63-2002") + kLineEnd;
  text += add("TEST", fmt::format("converted by luxgate from {}",
                                  source.format.empty() ? "a table" : source.format));
  text += add("TESTLAB", "not stated") + add("ISSUEDATE", "not stated");  // required keywords
  text += add("MANUFAC", source.manufacturer) + add("LUMINAIRE", source.luminaire_name);
  if (!source.applied_factors.empty()) {
    text += add("OTHER", "applied to the intensities: " + source.applied_factors);
  }
  text += std::string("TILT=NONE") + kLineEnd;
  const std::string lumens = source.rated_lamp_flux_lm > 0.0
                                 ? decimal_text(source.rated_lamp_flux_lm, 15, 6)
                                 : std::string("-1");
  text += fmt::format("1 {} 1 {} {} 1 2 {}{}", lumens, table.gamma_deg.size(),
                      written_planes(table).size(),
                      opening_text(web->opening(), {name, 0, 0}, diagnostics), kLineEnd);
  text += fmt::format("1 1 {}{}", decimal_text(source.input_power_w, 15, 6), kLineEnd);
  return text + table_text(table, web->max_intensity_cd());
}

}  // namespace calc
