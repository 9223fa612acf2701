#include "calc/photometry/write/stored_table.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/photometry/web_measures.h"
#include "calc/photometry/web_resample.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace calc {
namespace {

// Angles this near are the same one, such as the images of planes. More than readers want between
// two planes, less than type A and B tables have between the last angle and darkness (1e-5).
constexpr double kOneAngle_deg = 2.0e-6;

double rounded_degrees(double rad) { return std::round(degrees_from_radians(rad) * 1.0e9) / 1.0e9; }

// The table itself at a plane between its planes; at the poles, too, unlike intensity_cd().
double table_at(const PhotometricWeb& web, double c_deg, std::size_t gamma) {
  if (web.is_axial()) return web.table_cd(0, gamma);
  const double c = std::clamp(radians_from_degrees(c_deg), 0.0, 2.0 * kPi);
  const std::size_t plane = interval_of(web.c_rad(), c);
  const double fraction = (c - web.c_rad()[plane]) / (web.c_rad()[plane + 1] - web.c_rad()[plane]);
  return std::lerp(web.table_cd(plane, gamma), web.table_cd(plane + 1, gamma),
                   std::clamp(fraction, 0.0, 1.0));
}

double wrapped(double c_deg) {
  double c = std::fmod(c_deg, 360.0);
  if (c < 0.0) c += 360.0;
  return 360.0 - c < kOneAngle_deg ? 0.0 : c;
}

// As symmetry_fit(), but of the table: the values stored at the poles count.
PlaneSymmetry table_symmetry(const PhotometricWeb& web) {
  SymmetryFit fit;
  for (const double c_rad : web.c_rad()) {
    const double c = degrees_from_radians(c_rad);
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) {
      const double cd = table_at(web, c, g);
      fit.axial = std::max(fit.axial, std::abs(cd - web.table_cd(0, g)));
      fit.c0_c180 = std::max(fit.c0_c180, std::abs(cd - table_at(web, 360.0 - c, g)));
      fit.c90_c270 = std::max(fit.c90_c270, std::abs(cd - table_at(web, wrapped(180.0 - c), g)));
    }
  }
  return symmetry_within(fit, kExactSymmetry * web.max_intensity_cd());
}

std::vector<double> circle_of(const PhotometricWeb& web, PlaneSymmetry symmetry) {
  if (symmetry == PlaneSymmetry::axial) return {0.0};
  std::vector<double> wanted;
  for (std::size_t p = 0; p + 1 < web.c_rad().size(); ++p) {
    wanted.push_back(rounded_degrees(web.c_rad()[p]));
  }
  const std::size_t own = wanted.size();
  const bool mirror_c0 = symmetry == PlaneSymmetry::c0_c180 || symmetry == PlaneSymmetry::quadrant;
  const bool mirror_c90 =
      symmetry == PlaneSymmetry::c90_c270 || symmetry == PlaneSymmetry::quadrant;
  if (mirror_c0) wanted.push_back(180.0);
  if (mirror_c90) wanted.insert(wanted.end(), {90.0, 270.0});
  for (std::size_t i = 0; i < own; ++i) {
    const double c = wanted[i];
    if (mirror_c0) wanted.push_back(wrapped(360.0 - c));
    if (mirror_c90) wanted.push_back(wrapped(180.0 - c));
    if (mirror_c0 && mirror_c90) wanted.push_back(wrapped(180.0 + c));
  }
  std::stable_sort(wanted.begin(), wanted.end());
  std::vector<double> circle;
  for (const double c : wanted) {
    if (circle.empty() || c - circle.back() > kOneAngle_deg) circle.push_back(c);
  }
  return circle;
}

bool is_dark(const StoredTable& table, std::size_t gamma) {
  for (std::size_t p = 0; p < table.circle_c_deg.size(); ++p) {
    if (table.cd(p, gamma) > 0.0) return false;
  }
  return true;
}

void add_dark_angle(StoredTable& table, std::size_t at, double gamma_deg) {
  const std::size_t columns = table.gamma_deg.size();
  for (std::size_t p = table.circle_c_deg.size(); p-- > 0;) {
    table.intensity_cd.insert(
        table.intensity_cd.begin() + static_cast<std::ptrdiff_t>(p * columns + at), 0.0);
  }
  table.gamma_deg.insert(table.gamma_deg.begin() + static_cast<std::ptrdiff_t>(at), gamma_deg);
}

// An angle this near to the usual end becomes that end: beside another one no reader would take it.
void move_to_usual_ends(StoredTable& table, bool may_be_90) {
  double& first = table.gamma_deg.front();
  double& last = table.gamma_deg.back();
  for (const double end : {0.0, 90.0}) {
    if (first > end && first - end < kOneAngle_deg && (end == 0.0 || may_be_90)) first = end;
  }
  for (const double end : {90.0, 180.0}) {
    if (last < end && end - last < kOneAngle_deg) last = end;
  }
}

// False if the table is cut off in the light.
bool lead_to_usual_ends(StoredTable& table, LowestGamma lowest_gamma) {
  move_to_usual_ends(table, lowest_gamma == LowestGamma::zero_or_90);
  bool usual = true;
  const double last = table.gamma_deg.back();
  if (last != 90.0 && last != 180.0) {
    if (is_dark(table, table.gamma_deg.size() - 1)) {
      add_dark_angle(table, table.gamma_deg.size(), last < 90.0 ? 90.0 : 180.0);
    } else {
      usual = false;
    }
  }
  const double first = table.gamma_deg.front();
  const bool may_be_90 = lowest_gamma == LowestGamma::zero_or_90;
  if (first == 0.0 || (may_be_90 && first == 90.0)) return usual;
  if (!is_dark(table, 0)) return false;
  add_dark_angle(table, 0, may_be_90 && first > 90.0 ? 90.0 : 0.0);
  return usual;
}

}  // namespace

std::optional<PhotometricWeb> tabulated_over_c_gamma(const PhotometricWeb& web,
                                                     std::string_view format,
                                                     const std::string& name,
                                                     Diagnostics& diagnostics) {
  const SourceLocation file{name, 0, 0};
  if (has_c_gamma_table(web)) return web;
  std::optional<ResampledWeb> made = resampled_over_c_gamma(web);
  if (!made) {
    diagnostics.report(DiagnosticId::photometry_write_table, file, format);
    return std::nullopt;
  }
  diagnostics.report(DiagnosticId::photometry_write_resampled, file, format, made->c_step_deg,
                     made->gamma_step_deg, 100.0 * made->largest_share, made->flux_ratio);
  return std::move(made->web);
}

StoredTable make_stored_table(const PhotometricWeb& web, LowestGamma lowest_gamma,
                              std::string_view format, const std::string& name,
                              Diagnostics& diagnostics) {
  const SourceLocation file{name, 0, 0};
  StoredTable table;
  table.symmetry = table_symmetry(web);
  table.circle_c_deg = circle_of(web, table.symmetry);
  for (const double gamma : web.gamma_rad()) table.gamma_deg.push_back(rounded_degrees(gamma));
  for (const double c : table.circle_c_deg) {
    for (std::size_t g = 0; g < table.gamma_deg.size(); ++g) {
      table.intensity_cd.push_back(table_at(web, c, g));
    }
  }
  if (!lead_to_usual_ends(table, lowest_gamma)) {
    diagnostics.report(DiagnosticId::photometry_write_range, file, table.gamma_deg.front(),
                       table.gamma_deg.back(), format,
                       lowest_gamma == LowestGamma::zero ? "0" : "0 or 90");
  }
  return table;
}

int decimals_for(double value, int digits) {
  return std::clamp(digits - 1 - static_cast<int>(std::floor(calc::log10(value))), 0, 15);
}

std::string decimal_text(double value, int digits, int decimals) {
  const int places = value == 0.0 ? 0 : std::min(decimals, decimals_for(std::abs(value), digits));
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, places)
                       .ptr;
  std::string text(buffer.data(), end);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string file_line(std::string_view utf8, bool& lost) {
  std::string text;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto [code, length] = first_character(utf8.substr(i));
    i += std::max<std::size_t>(length, 1);
    if (length == 1) {
      text += code < 0x20 || code == 0x7F ? ' ' : static_cast<char>(code);
    } else if (code >= 0xA0 && code <= 0xFF) {
      text += static_cast<char>(code);
    } else {
      text += '?';
      lost = true;
    }
  }
  return text;
}

}  // namespace calc
