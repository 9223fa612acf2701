// Form factors between rectangles: the mean illuminance of one, lit by another of even exitance.

#include "report/tools/selftest/case.h"
#include "report/tools/selftest/closed_forms.h"

#include <fmt/format.h>

#include <cmath>

namespace cli::selftest {
namespace {

constexpr double kExitance = 1000.0;
constexpr int kGauss = 12;

// factor: from source to receiver. The mean over Gauss points is not quite that over the receiver:
// the same mean of exact point values says how far it is off.
CaseResult factor_between(const Rectangle& source, const Rectangle& receiver, double factor,
                          const Effort& effort) {
  Scene scene;
  scene.add_luminous(source, kExitance);
  std::vector<Point> points;
  std::vector<double> weights;
  double by_points = 0.0;
  for (const AreaPoint& p : points_on(receiver, kGauss)) {
    points.push_back({p.position_m, p.normal});
    weights.push_back(p.area_m2 / (kExitance * source.area_m2()));
    by_points += weights.back() * kExitance *
                 rectangle_factor(p.position_m, p.normal, source.corner, source.u, source.v);
  }
  CaseResult result;
  const double off = std::abs(by_points / factor - 1.0);
  result.add_sum(solve(scene, points, effort), fmt::format("F, by {0} x {0} points", kGauss), "",
                 weights, factor, 1.01 * off, 5e-3);
  return result;
}

// Floor a x b looking up at a ceiling c above it.
CaseResult opposite(double a, double b, double c, const Effort& effort) {
  return factor_between({{0, 0, c}, {0, b, 0}, {a, 0, 0}, kDown},
                        {{0, 0, 0}, {a, 0, 0}, {0, b, 0}, kUp}, opposite_rectangles(a, b, c),
                        effort);
}

// Wall of height h over a floor of width w, common edge l.
CaseResult at_right_angles(double l, double w, double h, const Effort& effort) {
  return factor_between({{0, 0, 0}, {0, 0, h}, {l, 0, 0}, {0, 1, 0}},
                        {{0, 0, 0}, {l, 0, 0}, {0, w, 0}, kUp}, rectangles_with_edge(l, h, w),
                        effort);
}

}  // namespace

std::vector<SelftestCase> factor_cases() {
  return {{"cube-opposite", "factor", "Opposite faces of a cube: 0.1998249", "Howell C-11",
           [](const Effort& e) { return opposite(1, 1, 1, e); }},
          {"cube-adjacent", "factor", "Adjacent faces of a cube: 0.2000438", "Howell C-14",
           [](const Effort& e) { return at_right_angles(1, 1, 1, e); }},
          {"plates-far", "factor", "Squares ten sides apart", "Howell C-11",
           [](const Effort& e) { return opposite(1, 1, 10, e); }},
          {"plates-near", "factor", "Plates 1 x 1.5 m, 0.5 m apart", "Howell C-11",
           [](const Effort& e) { return opposite(1, 1.5, 0.5, e); }},
          {"wall-and-floor", "factor", "Wall 4 x 2.5 m over a floor 4 x 6 m", "Howell C-14",
           [](const Effort& e) { return at_right_angles(4, 6, 2.5, e); }},
          {"plates-1-to-1000", "factor", "Facing strips 1000 x 1 m, 1 m apart", "Howell C-11",
           [](const Effort& e) { return opposite(1000, 1, 1, e); }}};
}

}  // namespace cli::selftest
