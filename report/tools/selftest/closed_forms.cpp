#include "report/tools/selftest/closed_forms.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cli::selftest {
namespace {

using calc::kPi;

// What of the polygon is above the plane through 0 with normal n; corners relative to the receiver.
std::vector<glm::dvec3> above_horizon(const std::vector<glm::dvec3>& corners, const glm::dvec3& n) {
  std::vector<glm::dvec3> kept;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double ha = glm::dot(a, n), hb = glm::dot(b, n);
    if (ha >= 0.0) kept.push_back(a);
    if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0)) {
      kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
  }
  return kept;
}

}  // namespace

double polygon_factor(const glm::dvec3& x, const glm::dvec3& n,
                      const std::vector<glm::dvec3>& corners) {
  std::vector<glm::dvec3> seen;
  double highest = 0.0;
  for (const glm::dvec3& corner : corners) {
    seen.push_back(corner - x);
    highest = std::max(highest, glm::dot(corner - x, n));
  }
  if (highest < 1e-12) return 0.0;  // in the receiver's own plane or behind it
  seen = above_horizon(seen, n);
  if (seen.size() < 3) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const glm::dvec3 a = glm::normalize(seen[k]);
    const glm::dvec3 b = glm::normalize(seen[(k + 1) % seen.size()]);
    const glm::dvec3 c = glm::cross(a, b);
    const double s = glm::length(c);
    if (s < 1e-15) continue;
    sum += calc::atan2(s, glm::dot(a, b)) / s * glm::dot(c, n);
  }
  return std::abs(sum) / (2.0 * kPi);
}

double rectangle_factor(const glm::dvec3& x, const glm::dvec3& n, const glm::dvec3& corner,
                        const glm::dvec3& u, const glm::dvec3& v) {
  return polygon_factor(x, n, {corner, corner + u, corner + u + v, corner + v});
}

double disc_factor_parallel(double r, double h, double offset) {
  const double z = offset * offset + h * h + r * r;
  return 0.5 * (1.0 - (offset * offset + h * h - r * r) /
                          std::sqrt(z * z - 4.0 * offset * offset * r * r));
}

double disc_factor_perpendicular(double r, double h, double offset) {
  const double z = offset * offset + h * h + r * r;
  return h / (2.0 * offset) * (z / std::sqrt(z * z - 4.0 * offset * offset * r * r) - 1.0);
}

double sphere_factor(double r, double d, double t) {
  const double ratio = d / r, dip = calc::asin(1.0 / ratio);  // half of the sphere's width
  if (t <= 0.5 * kPi - dip) return calc::cos(t) / (ratio * ratio);
  if (t >= 0.5 * kPi + dip) return 0.0;
  const double x = std::sqrt(ratio * ratio - 1.0), y = -x / calc::tan(t);
  const double w = calc::sin(t) * std::sqrt(1.0 - y * y);
  return (calc::cos(t) * calc::acos(y) - x * w) / (kPi * ratio * ratio) + calc::atan(w / x) / kPi;
}

double opposite_rectangles(double a, double b, double c) {
  const double x = a / c, y = b / c, x1 = std::sqrt(1.0 + x * x), y1 = std::sqrt(1.0 + y * y);
  return 2.0 / (kPi * x * y) *
         (0.5 * calc::log(x1 * x1 * y1 * y1 / (1.0 + x * x + y * y)) + x * y1 * calc::atan(x / y1) +
          y * x1 * calc::atan(y / x1) - x * calc::atan(x) - y * calc::atan(y));
}

double rectangles_with_edge(double l, double w, double h) {
  const double ww = w * w / (l * l), hh = h * h / (l * l), s = ww + hh;
  const double ratio = (1.0 + ww) * (1.0 + hh) / (1.0 + s);
  const double w_part = calc::pow(ww * (1.0 + s) / ((1.0 + ww) * s), ww);
  const double h_part = calc::pow(hh * (1.0 + s) / ((1.0 + hh) * s), hh);
  const double rw = w / l, rh = h / l;
  return (rw * calc::atan(1.0 / rw) + rh * calc::atan(1.0 / rh) -
          std::sqrt(s) * calc::atan(1.0 / std::sqrt(s)) +
          0.25 * calc::log(ratio * w_part * h_part)) /
         (kPi * rw);
}

double corner_solid_angle(double a, double b, double h) {
  return calc::atan(a * b / (h * std::sqrt(a * a + b * b + h * h)));
}

}  // namespace cli::selftest
