#include "calc/photometry/web.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/photometry/sine_segment.h"
#include "calc/photometry/web_sketch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace calc {
namespace {

// Directions are made and read with sin, cos and atan2: a few roundings of an angle of up to pi.
constexpr double kAngleRounding_rad = 1.0e-14;

void require(bool condition, const char* what) {
  if (!condition) throw std::logic_error(std::string("PhotometricWeb: ") + what);
}

bool strictly_ascending(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(),
                            [](double a, double b) { return !(a < b); }) == values.end();
}

void require_valid(const std::vector<double>& c_rad, const std::vector<double>& gamma_rad,
                   const std::vector<double>& intensity_cd) {
  require(!c_rad.empty(), "at least one plane");
  require(gamma_rad.size() >= 2, "at least two gamma angles");
  require(intensity_cd.size() == c_rad.size() * gamma_rad.size(), "table size");
  require(strictly_ascending(c_rad) && strictly_ascending(gamma_rad), "ascending angles");
  require(gamma_rad.front() >= 0.0 && gamma_rad.back() <= kPi, "gamma in [0, pi]");
  require(c_rad.front() == 0.0, "first plane at C = 0");
  require(c_rad.size() == 1 || c_rad.back() == 2.0 * kPi, "last plane at C = 2 pi");
  const auto columns = static_cast<std::ptrdiff_t>(gamma_rad.size());
  require(std::equal(intensity_cd.begin(), intensity_cd.begin() + columns,
                     intensity_cd.end() - columns),
          "last plane equal to the first");
  require(std::all_of(intensity_cd.begin(), intensity_cd.end(),
                      [](double cd) { return std::isfinite(cd) && cd >= 0.0; }),
          "intensities finite and >= 0");
}

}  // namespace

PhotometricWeb PhotometricWeb::make(std::vector<double> c_rad, std::vector<double> gamma_rad,
                                    std::vector<double> intensity_cd, LuminousOpening opening,
                                    PhotometrySource source, TableAxis axis) {
  require_valid(c_rad, gamma_rad, intensity_cd);
  PhotometricWeb web;
  web.axis_ = axis;
  web.c_rad_ = std::move(c_rad);
  web.gamma_rad_ = std::move(gamma_rad);
  web.intensity_cd_ = std::move(intensity_cd);
  web.opening_ = opening;
  web.source_ = std::move(source);
  web.max_intensity_cd_ = *std::max_element(web.intensity_cd_.begin(), web.intensity_cd_.end());
  if (web.gamma_rad_.front() == 0.0) web.nadir_cd_ = web.mean_over_c_cd(0);
  if (web.gamma_rad_.back() == kPi) web.zenith_cd_ = web.mean_over_c_cd(web.gamma_rad_.size() - 1);
  web.flux_lm_ = web.table_zone_lm(0.0, kPi);
  require(std::isfinite(web.flux_lm_) && web.flux_lm_ > 0.0, "flux finite and > 0");
  web.sketch_ = std::make_shared<LazyWebSketch>();
  return web;
}

const WebSketch& PhotometricWeb::sketch() const { return sketch_->of(*this); }

double PhotometricWeb::mean_over_c_cd(std::size_t gamma) const {
  const double first = table_cd(0, gamma);
  double sum =
      0.0;  // of the differences, so that planes that agree give their value without rounding
  for (std::size_t plane = 0; plane + 1 < c_rad_.size(); ++plane) {
    const double width = c_rad_[plane + 1] - c_rad_[plane];
    sum += 0.5 * width * ((table_cd(plane, gamma) - first) + (table_cd(plane + 1, gamma) - first));
  }
  return std::max(0.0, first + sum / (2.0 * kPi));
}

double PhotometricWeb::interpolate_gamma_cd(std::size_t plane, std::size_t gamma,
                                            double fraction) const {
  return std::lerp(table_cd(plane, gamma), table_cd(plane, gamma + 1), fraction);
}

std::array<double, 3> PhotometricWeb::to_table(const std::array<double, 3>& direction) const {
  const auto [x, y, z] = direction;
  if (axis_ == TableAxis::vertical) return direction;
  return {-z, x, -y};
}

std::array<double, 3> PhotometricWeb::from_table(const std::array<double, 3>& direction) const {
  const auto [x, y, z] = direction;
  if (axis_ == TableAxis::vertical) return direction;
  return {y, -z, -x};
}

double PhotometricWeb::intensity_cd(const std::array<double, 3>& direction) const {
  const std::array<double, 3> turned = to_table(direction);
  if (is_axial()) {  // C does not matter
    const double across = std::sqrt(turned[0] * turned[0] + turned[1] * turned[1]);
    return at_table_angles_cd(0.0, calc::atan2(across, -turned[2]));
  }
  const WebAngles angles = angles_of(turned);
  return at_table_angles_cd(angles.c_rad, angles.gamma_rad);
}

double PhotometricWeb::intensity_cd(double c_rad, double gamma_rad) const {
  if (axis_ == TableAxis::vertical) return at_table_angles_cd(c_rad, gamma_rad);
  return intensity_cd(direction_of({c_rad, gamma_rad}));
}

double PhotometricWeb::at_table_angles_cd(double c_rad, double gamma_rad) const {
  if (gamma_rad <= 0.0) return nadir_cd_;
  if (gamma_rad >= kPi) return zenith_cd_;
  if (gamma_rad < gamma_rad_.front() - kAngleRounding_rad) return 0.0;
  if (gamma_rad > gamma_rad_.back() + kAngleRounding_rad) return 0.0;
  const std::size_t gamma = interval_of(gamma_rad_, gamma_rad);
  const double width = gamma_rad_[gamma + 1] - gamma_rad_[gamma];
  const double fraction = std::clamp((gamma_rad - gamma_rad_[gamma]) / width, 0.0, 1.0);
  if (is_axial()) return interpolate_gamma_cd(0, gamma, fraction);

  double c = c_rad;
  if (!(c >= 0.0 && c <= 2.0 * kPi)) {
    c = std::fmod(c, 2.0 * kPi);
    if (c < 0.0) c += 2.0 * kPi;
  }
  const std::size_t plane = interval_of(c_rad_, c);
  const double c_fraction = (c - c_rad_[plane]) / (c_rad_[plane + 1] - c_rad_[plane]);
  return std::lerp(interpolate_gamma_cd(plane, gamma, fraction),
                   interpolate_gamma_cd(plane + 1, gamma, fraction),
                   std::clamp(c_fraction, 0.0, 1.0));
}

double PhotometricWeb::zonal_flux_lm(double from_gamma_rad, double to_gamma_rad) const {
  if (axis_ == TableAxis::vertical) return table_zone_lm(from_gamma_rad, to_gamma_rad);
  constexpr double kStep_rad = kPi / 360.0;
  const double zone_rad = to_gamma_rad - from_gamma_rad;
  if (!(zone_rad > 0.0)) return 0.0;
  const auto rows = static_cast<int>(std::ceil(zone_rad / kStep_rad));
  double sum_lm = 0.0;
  for (int i = 0; i < rows; ++i) {
    const double low = from_gamma_rad + zone_rad * i / rows;
    const double high = from_gamma_rad + zone_rad * (i + 1) / rows;
    const double cell_sr = (calc::cos(low) - calc::cos(high)) * kStep_rad;
    for (int k = 0; k < 720; ++k) {
      sum_lm += cell_sr * intensity_cd(kStep_rad * (k + 0.5), 0.5 * (low + high));
    }
  }
  return sum_lm;
}

double PhotometricWeb::table_zone_lm(double from_gamma_rad, double to_gamma_rad) const {
  const auto plane_flux = [&](std::size_t plane) {  // lm per radian of C
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < gamma_rad_.size(); ++i) {
      const SineSegment segment{gamma_rad_[i], gamma_rad_[i + 1] - gamma_rad_[i],
                                table_cd(plane, i), table_cd(plane, i + 1)};
      const double from = std::max(from_gamma_rad, gamma_rad_[i]) - gamma_rad_[i];
      const double to = std::min(to_gamma_rad, gamma_rad_[i + 1]) - gamma_rad_[i];
      if (from < to) sum += integral_to(segment, to) - integral_to(segment, from);
    }
    return sum;
  };
  double previous = plane_flux(0);
  if (is_axial()) return 2.0 * kPi * previous;
  double flux = 0.0;
  for (std::size_t plane = 1; plane < c_rad_.size(); ++plane) {
    const double current = plane_flux(plane);
    flux += 0.5 * (c_rad_[plane] - c_rad_[plane - 1]) * (previous + current);  // exact: linear in C
    previous = current;
  }
  return flux;
}

WebAngles angles_of(const std::array<double, 3>& direction) {
  const auto [x, y, z] = direction;
  const double across = std::sqrt(x * x + y * y);
  if (across == 0.0) return {0.0, z > 0.0 ? kPi : 0.0};
  const auto [c, gamma] = calc::atan2({y, across}, {x, -z});
  return {c < 0.0 ? c + 2.0 * kPi : c, gamma};
}

std::array<double, 3> direction_of(const WebAngles& angles) {
  const double across = calc::sin(angles.gamma_rad);
  return {across * calc::cos(angles.c_rad), across * calc::sin(angles.c_rad),
          -calc::cos(angles.gamma_rad)};
}

std::size_t interval_of(const std::vector<double>& nodes, double x) {
  // Tables are mostly evenly spaced: the guess is then right or next to it.
  const double share = (x - nodes.front()) / (nodes.back() - nodes.front());
  const auto last = nodes.size() - 2;
  if (share >= 0.0 && share < 1.0) {
    const auto guess =
        std::min(last, static_cast<std::size_t>(share * static_cast<double>(last + 1)));
    if (nodes[guess] <= x && x < nodes[guess + 1]) return guess;
  }
  const auto after = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
  return static_cast<std::size_t>(after - nodes.begin()) - 1;
}

}  // namespace calc
