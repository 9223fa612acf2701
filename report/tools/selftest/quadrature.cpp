#include "report/tools/selftest/quadrature.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cli::selftest {
namespace {

constexpr int kCellPoints = 4;
constexpr double kCellSize = 0.4;     // of the distance
constexpr double kSmallest_m = 1e-9;  // cells are not split further: a receiver in the surface

struct Integral {
  const Rectangle& source;
  const SurfaceValue& exitance;
  const std::vector<glm::dvec3>& hot;
  const glm::dvec3 &x, &n;
  GaussRule rule = gauss_rule(kCellPoints);

  double at(const glm::dvec3& y) const {
    const glm::dvec3 w = y - x;
    const double cx = glm::dot(n, w), cy = -glm::dot(source.normal, w);
    if (!(cx > 0.0) || !(cy > 0.0)) return 0.0;
    const double d2 = glm::dot(w, w);
    return exitance(y) * cx * cy / (calc::kPi * d2 * d2);
  }

  double over(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) const {
    const double lu = glm::length(u), lv = glm::length(v), size = std::max(lu, lv);
    const glm::dvec3 centre = corner + 0.5 * (u + v);
    double distance = glm::length(centre - x);
    for (const glm::dvec3& h : hot) distance = std::min(distance, glm::length(centre - h));
    if (size > kCellSize * distance && size > kSmallest_m) {
      if (lu > 2.0 * lv) return over(corner, 0.5 * u, v) + over(corner + 0.5 * u, 0.5 * u, v);
      if (lv > 2.0 * lu) return over(corner, u, 0.5 * v) + over(corner + 0.5 * v, u, 0.5 * v);
      const glm::dvec3 a = 0.5 * u, b = 0.5 * v;
      return over(corner, a, b) + over(corner + a, a, b) + over(corner + b, a, b) +
             over(corner + a + b, a, b);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.at.size(); ++i) {
      for (std::size_t k = 0; k < rule.at.size(); ++k) {
        sum += rule.weight[i] * rule.weight[k] * at(corner + rule.at[i] * u + rule.at[k] * v);
      }
    }
    return sum * lu * lv;
  }
};

}  // namespace

GaussRule gauss_rule(int n) {
  GaussRule rule;
  for (int k = 0; k < n; ++k) {
    double x = calc::cos(calc::kPi * (k + 0.75) / (n + 0.5)), slope = 1.0;
    for (int step = 0; step < 50; ++step) {  // Newton's method on the Legendre polynomial
      double p = 1.0, before = 0.0;
      for (int j = 1; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * p - (j - 1) * before) / j;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0);
      const double change = p / slope;
      x -= change;
      if (std::abs(change) < 1e-15) break;
    }
    rule.at.push_back(0.5 * (1.0 - x));
    rule.weight.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

std::array<Rectangle, 6> faces_of_box(const glm::dvec3& low, const glm::dvec3& size) {
  std::array<Rectangle, 6> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      Rectangle face{low, glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
      face.corner[axis] += side * size[axis];
      face.u[(axis + 1) % 3] = size[(axis + 1) % 3];
      face.v[(axis + 2) % 3] = size[(axis + 2) % 3];
      face.normal[axis] = side == 0 ? 1.0 : -1.0;
      faces[static_cast<std::size_t>(2 * axis + side)] = face;
    }
  }
  return faces;
}

std::vector<AreaPoint> points_on(const Rectangle& rectangle, int n) {
  const GaussRule rule = gauss_rule(n);
  std::vector<AreaPoint> points;
  for (std::size_t i = 0; i < rule.at.size(); ++i) {
    for (std::size_t k = 0; k < rule.at.size(); ++k) {
      points.push_back({rectangle.corner + rule.at[i] * rectangle.u + rule.at[k] * rectangle.v,
                        rectangle.normal, rule.weight[i] * rule.weight[k] * rectangle.area_m2()});
    }
  }
  return points;
}

double reflected_lx(const Rectangle& source, const SurfaceValue& exitance,
                    const std::vector<glm::dvec3>& hot, const glm::dvec3& x, const glm::dvec3& n) {
  return Integral{source, exitance, hot, x, n}.over(source.corner, source.u, source.v);
}

}  // namespace cli::selftest
