#include "calc/photometry/read/web_assembly.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace calc {
namespace {

constexpr double kNoiseShare = 1.0e-3;       // of the maximum: negative values up to this are noise
constexpr double kDimmest_cd = 1.0e-9;       // a maximum below this is no light
constexpr double kBrightest_cd = 1.0e12;     // far above any searchlight
constexpr double kPoleSpreadShare = 0.03;    // of the value at the pole
constexpr double kCircleSpreadShare = 0.01;  // of the maximum
constexpr double kCutShare = 0.05;           // of the maximum, at the last angle
constexpr double kSmallestStep_deg = 1.0e-6;  // keeps radians apart
constexpr double kSmallestOpening_m = 1.0e-6, kLargestOpening_m = 1.0e4;
constexpr double kLeastStated = 1.0e-6, kMostStated = 1.0e12;  // lumens of lamps, watts

bool check_and_clean_values(FileTable& table, Diagnostics& diagnostics) {
  const auto [lowest, highest] =
      std::minmax_element(table.intensity_cd.begin(), table.intensity_cd.end());
  const double minimum = *lowest;
  const double maximum = *highest;
  if (maximum < kDimmest_cd && minimum > -kDimmest_cd) {
    diagnostics.report(DiagnosticId::photometry_no_light, table.where);
    return false;
  }
  if (minimum < -kNoiseShare * std::max(maximum, 0.0)) {
    diagnostics.report(DiagnosticId::photometry_negative, table.most_negative_where, minimum);
    return false;
  }
  if (maximum > kBrightest_cd) {
    diagnostics.report(DiagnosticId::photometry_value, table.where, "the highest intensity (cd)",
                       fmt::format("{}", maximum), "up to 1e12");
    return false;
  }
  std::size_t cleaned = 0;
  for (double& cd : table.intensity_cd) {
    if (cd < 0.0) ++cleaned;
    if (cd <= 0.0) cd = 0.0;  // -0 too
  }
  if (cleaned > 0) {
    diagnostics.report(DiagnosticId::photometry_noise, table.most_negative_where, cleaned, minimum);
  }
  return true;
}

// What the file says besides the table; readers have refused numbers below 0.
bool check_statements(const LuminousOpening& opening, const PhotometrySource& source,
                      const SourceLocation& where, Diagnostics& diagnostics) {
  const auto holds = [&](const char* what, double value, double least, double most) {
    if (value == 0.0 || (value >= least && value <= most)) return true;
    diagnostics.report(DiagnosticId::photometry_value, where, what, fmt::format("{}", value),
                       fmt::format("0 or {:g} to {:g}", least, most));
    return false;
  };
  const double largest_m = std::max({opening.along_c0_m, opening.along_c90_m, opening.height_m});
  return holds("the flux of all lamps (lm)", source.rated_lamp_flux_lm, kLeastStated,
               kMostStated) &&
         holds("the input power (W)", source.input_power_w, kLeastStated, kMostStated) &&
         holds("the luminous opening's largest side (m)", largest_m, kSmallestOpening_m,
               kLargestOpening_m);
}

// The greatest intensity where the table ends, and where it ends but by its format goes on: lists
// begin at 0 or 90 and end at 90 or 180, and beyond these there is no light.
struct EndIntensities {
  double all_cd = 0.0, open_cd = 0.0;
};

EndIntensities intensities_at_ends(const FileTable& table) {
  const double first = table.gamma_deg.front(), last = table.gamma_deg.back();
  const auto ends_a_half = [](double deg) {
    constexpr double kPrinted_deg = 1.0e-3;
    return std::abs(deg - 90.0) <= kPrinted_deg;
  };
  const std::size_t columns = table.gamma_deg.size();
  EndIntensities ends;
  for (std::size_t i = 0; i < table.intensity_cd.size(); i += columns) {
    const double at_first = table.intensity_cd[i], at_last = table.intensity_cd[i + columns - 1];
    if (first > 0.0) ends.all_cd = std::max(ends.all_cd, at_first);
    if (last < 180.0) ends.all_cd = std::max(ends.all_cd, at_last);
    if (first > 0.0 && !ends_a_half(first)) ends.open_cd = std::max(ends.open_cd, at_first);
    if (last < 180.0 && !ends_a_half(last)) ends.open_cd = std::max(ends.open_cd, at_last);
  }
  return ends;
}

void warn_of_gamma_range(const FileTable& table, double maximum_cd, Diagnostics& diagnostics) {
  const double first = table.gamma_deg.front();
  const double last = table.gamma_deg.back();
  const bool usual = (first == 0.0 || first == 90.0) && (last == 90.0 || last == 180.0);
  const double at_ends_cd = intensities_at_ends(table).all_cd;
  if (usual && at_ends_cd <= kCutShare * maximum_cd) return;
  diagnostics.report(DiagnosticId::photometry_gamma_range, table.where, first, last, at_ends_cd);
}

// The share of the maximum that the table has at an end beyond which nothing is known; 0 = there is
// no such end, or it is dark there.
double find_open_end(const FileTable& table, double maximum_cd, Diagnostics& diagnostics) {
  double open_cd = table.at_open_ends_cd;
  if (table.axis == TableAxis::vertical) {
    open_cd = std::max(open_cd, intensities_at_ends(table).open_cd);
  }
  if (open_cd <= kNoiseShare * maximum_cd) return 0.0;
  const double share = open_cd / maximum_cd;
  diagnostics.report(DiagnosticId::photometry_open_end, table.where, open_cd, 100.0 * share);
  return share;
}

void warn_of_poles(const FileTable& table, Diagnostics& diagnostics) {
  const std::size_t columns = table.gamma_deg.size();
  for (const std::size_t column : {std::size_t{0}, columns - 1}) {
    const double gamma = table.gamma_deg[column];
    if (gamma != 0.0 && gamma != 180.0) continue;
    double low = table.intensity_cd[column];
    double high = low;
    for (std::size_t i = column; i < table.intensity_cd.size(); i += columns) {
      low = std::min(low, table.intensity_cd[i]);
      high = std::max(high, table.intensity_cd[i]);
    }
    if (high - low > kPoleSpreadShare * high) {
      diagnostics.report(DiagnosticId::photometry_pole_spread, table.where, gamma, low, high);
    }
  }
}

void warn_of_circle(const FileTable& table, const std::vector<CirclePlane>& circle,
                    double maximum_cd, Diagnostics& diagnostics) {
  if (table.symmetry != PlaneSymmetry::none) return;
  const double last = table.c_deg.back();
  if (circle.front().weight != 0.5 || last < 360.0 - kSmallestStep_deg) {
    if (!table.lists_c360) return;
    diagnostics.report(DiagnosticId::photometry_circle_closed, table.where, table.c_deg.front(),
                       last);
    return;
  }
  const std::size_t columns = table.gamma_deg.size();
  double widest = 0.0;
  for (std::size_t i = 0; i < columns; ++i) {
    widest = std::max(widest, std::abs(table.intensity_cd[circle.front().first * columns + i] -
                                       table.intensity_cd[circle.front().second * columns + i]));
  }
  if (widest > kCircleSpreadShare * maximum_cd) {
    diagnostics.report(DiagnosticId::photometry_circle_differs, table.where, widest,
                       100.0 * widest / maximum_cd);
  }
}

double radians(double deg) { return deg >= 360.0 ? 2.0 * kPi : deg * kPi / 180.0; }

}  // namespace

std::optional<PhotometricWeb> make_checked_web(FileTable table, const LuminousOpening& opening,
                                               PhotometrySource source, Diagnostics& diagnostics) {
  if (!check_and_clean_values(table, diagnostics)) return std::nullopt;
  if (!check_statements(opening, source, table.where, diagnostics)) return std::nullopt;
  const std::vector<CirclePlane> circle = full_circle(table.c_deg, table.symmetry);
  if (circle.empty()) {
    diagnostics.report(DiagnosticId::photometry_planes, table.where, table.c_deg.front(),
                       table.c_deg.back());
    return std::nullopt;
  }
  const double maximum = *std::max_element(table.intensity_cd.begin(), table.intensity_cd.end());
  if (table.axis == TableAxis::vertical) {  // else the words would name the wrong places
    warn_of_gamma_range(table, maximum, diagnostics);
    warn_of_poles(table, diagnostics);
  }
  warn_of_circle(table, circle, maximum, diagnostics);
  source.open_end_share = find_open_end(table, maximum, diagnostics);

  std::vector<double> c_rad;
  std::vector<double> expanded_cd;
  const std::size_t columns = table.gamma_deg.size();
  expanded_cd.reserve(circle.size() * columns);
  for (const CirclePlane& plane : circle) {
    c_rad.push_back(radians(plane.c_deg));
    for (std::size_t i = 0; i < columns; ++i) {
      expanded_cd.push_back(std::lerp(table.intensity_cd[plane.first * columns + i],
                                      table.intensity_cd[plane.second * columns + i],
                                      plane.weight));
    }
  }
  std::vector<double> gamma_rad;
  for (const double deg : table.gamma_deg) gamma_rad.push_back(deg >= 180.0 ? kPi : radians(deg));
  return PhotometricWeb::make(std::move(c_rad), std::move(gamma_rad), std::move(expanded_cd),
                              opening, std::move(source), table.axis);
}

bool check_angle(double deg, const double* previous, double lowest_deg, double highest_deg,
                 const char* what, const SourceLocation& where, Diagnostics& diagnostics) {
  if (deg < lowest_deg || deg > highest_deg) {
    diagnostics.report(DiagnosticId::photometry_value, where, fmt::format("{} angle", what),
                       fmt::format("{}", deg),
                       fmt::format("{} to {} degrees", lowest_deg, highest_deg));
    return false;
  }
  if (previous != nullptr && deg - *previous < kSmallestStep_deg) {
    diagnostics.report(DiagnosticId::photometry_angle_order, where, what, deg, *previous);
    return false;
  }
  return true;
}

void warn_of_low_flux(double flux_lm, double rated_lm, const SourceLocation& where,
                      Diagnostics& diagnostics) {
  // Few luminaires lose more of their light. One that keeps 95 % or more of it has about 1000 lm
  // where its table is that of 1000 lm.
  constexpr double kUnusualEfficiency = 0.2;
  constexpr double kLowest_lm = 950.0, kHighest_lm = 1010.0;
  const bool is_more_rated = rated_lm > kEfficiencyLimit * flux_lm;
  const bool is_of_1000_lm = flux_lm >= kLowest_lm && flux_lm <= kHighest_lm && is_more_rated;
  if (flux_lm >= kUnusualEfficiency * rated_lm && !is_of_1000_lm) return;
  diagnostics.report(DiagnosticId::photometry_low_flux, where, flux_lm, 100.0 * flux_lm / rated_lm,
                     rated_lm);
}

}  // namespace calc
