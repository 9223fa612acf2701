#include "calc/photometry/web_hermite.h"

#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace calc {
namespace {

constexpr std::size_t kGammaParts = 8;
constexpr std::size_t kCParts = 4;

// Slope at a node from the secants and widths of its two intervals: 0 at an extremum, else a
// weighted harmonic mean.
double limited_slope(double left, double right, double left_width, double right_width) {
  if (!(left * right > 0.0)) return 0.0;
  const double share = (left_width + 2.0 * right_width) / (3.0 * (left_width + right_width));
  return left * right / (share * right + (1.0 - share) * left);
}

double hermite(double a, double b, double slope_a, double slope_b, double width, double t) {
  const double s = 1.0 - t;
  return a * s * s * (1.0 + 2.0 * t) + b * t * t * (1.0 + 2.0 * s) +
         width * s * t * (slope_a * s - slope_b * t);
}

std::vector<double> refined(const std::vector<double>& node, std::size_t parts) {
  std::vector<double> fine;
  for (std::size_t i = 0; i + 1 < node.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(parts);
      fine.push_back(std::lerp(node[i], node[i + 1], t));
    }
  }
  fine.push_back(node.back());
  return fine;
}

// One curve on refined nodes. before, after: secants and widths beyond the ends; width 0 = none,
// the end's slope is then its interval's secant, limited like the others.
struct Beyond {
  double secant = 0.0, width = 0.0;
};
std::vector<double> refined_curve(const std::vector<double>& node, const std::vector<double>& value,
                                  const Beyond& before, const Beyond& after, std::size_t parts) {
  std::vector<double> secant;
  for (std::size_t i = 0; i + 1 < node.size(); ++i) {
    secant.push_back((value[i + 1] - value[i]) / (node[i + 1] - node[i]));
  }
  const std::size_t last = secant.size();
  const auto slope = [&](std::size_t i) {
    if (i == 0 && before.width == 0.0) return secant.front();
    if (i == last && after.width == 0.0) return secant.back();
    const double left = i > 0 ? secant[i - 1] : before.secant;
    const double right = i < last ? secant[i] : after.secant;
    const double left_width = i > 0 ? node[i] - node[i - 1] : before.width;
    const double right_width = i < last ? node[i + 1] - node[i] : after.width;
    return limited_slope(left, right, left_width, right_width);
  };
  std::vector<double> curve;
  double slope_a = slope(0);
  for (std::size_t i = 0; i < last; ++i) {
    const double slope_b = slope(i + 1);
    for (std::size_t k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(parts);
      const double cd = hermite(value[i], value[i + 1], slope_a, slope_b, node[i + 1] - node[i], t);
      // Rounding only: the curve lies between its ends.
      curve.push_back(
          std::clamp(cd, std::min(value[i], value[i + 1]), std::max(value[i], value[i + 1])));
    }
    slope_a = slope_b;
  }
  curve.push_back(value.back());
  return curve;
}

std::vector<double> plane_values(const PhotometricWeb& web, std::size_t plane) {
  std::vector<double> values;
  for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) values.push_back(web.table_cd(plane, g));
  return values;
}

// Value of gamma entry g half a turn away from a plane: the curve goes on there beyond a pole.
double opposite_cd(const PhotometricWeb& web, std::size_t plane, std::size_t g) {
  if (web.is_axial()) return web.table_cd(0, g);
  const std::vector<double>& c = web.c_rad();
  const double turned = c[plane] < kPi ? c[plane] + kPi : c[plane] - kPi;
  const std::size_t i = interval_of(c, turned);
  return std::lerp(web.table_cd(i, g), web.table_cd(i + 1, g), (turned - c[i]) / (c[i + 1] - c[i]));
}

std::vector<double> refined_plane(const PhotometricWeb& web, std::size_t plane) {
  const std::vector<double>& gamma = web.gamma_rad();
  const std::vector<double> value = plane_values(web, plane);
  const std::size_t last = gamma.size() - 1;
  Beyond before, after;
  if (gamma.front() == 0.0) {
    before.width = gamma[1];
    before.secant = (value[0] - opposite_cd(web, plane, 1)) / before.width;
  }
  if (gamma.back() == kPi) {
    after.width = kPi - gamma[last - 1];
    after.secant = (opposite_cd(web, plane, last - 1) - value[last]) / after.width;
  }
  return refined_curve(gamma, value, before, after, kGammaParts);
}

}  // namespace

PhotometricWeb hermite_refined(const PhotometricWeb& web) {
  std::vector<double> gamma_rad = refined(web.gamma_rad(), kGammaParts);
  std::vector<double> c_rad = web.c_rad();
  std::vector<std::vector<double>> planes;
  for (std::size_t p = 0; p < c_rad.size(); ++p) planes.push_back(refined_plane(web, p));
  std::vector<double> table;
  if (web.is_axial()) {
    table = std::move(planes[0]);
  } else {
    const std::vector<double> fine_c_rad = refined(c_rad, kCParts);
    const std::size_t columns = gamma_rad.size(), last = c_rad.size() - 1;
    table.resize(fine_c_rad.size() * columns);
    for (std::size_t g = 0; g < columns; ++g) {
      std::vector<double> around;
      for (const std::vector<double>& plane : planes) around.push_back(plane[g]);
      const Beyond before{(around[last] - around[last - 1]) / (c_rad[last] - c_rad[last - 1]),
                          c_rad[last] - c_rad[last - 1]};
      const Beyond after{(around[1] - around[0]) / c_rad[1], c_rad[1]};
      const std::vector<double> curve = refined_curve(c_rad, around, before, after, kCParts);
      for (std::size_t p = 0; p < curve.size(); ++p) table[p * columns + g] = curve[p];
    }
    c_rad = fine_c_rad;
  }
  return PhotometricWeb::make(std::move(c_rad), std::move(gamma_rad), std::move(table),
                              web.opening(), web.source(), web.axis());
}

InterpolationDifference interpolation_difference(const PhotometricWeb& web) {
  const PhotometricWeb cubic = hermite_refined(web);
  double largest_cd = 0.0;
  for (std::size_t p = 0; p < cubic.c_rad().size(); ++p) {
    for (std::size_t g = 0; g < cubic.gamma_rad().size(); ++g) {
      // Both tables have the same axis.
      const auto direction = web.from_table(direction_of({cubic.c_rad()[p], cubic.gamma_rad()[g]}));
      largest_cd =
          std::max(largest_cd, std::abs(cubic.table_cd(p, g) - web.intensity_cd(direction)));
    }
  }
  return {largest_cd / web.max_intensity_cd(), cubic.flux_lm() / web.flux_lm() - 1.0};
}

}  // namespace calc
