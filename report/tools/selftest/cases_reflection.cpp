// One diffuse reflection: from an evenly lit surface by Lambert's formula, from one that a lamp
// lights by quadrature.

#include "calc/base/units.h"
#include "report/tools/selftest/case.h"
#include "report/tools/selftest/closed_forms.h"

#include <cmath>

namespace cli::selftest {
namespace {

using calc::kPi;

// CIE 171:2006, 5.6: points on a wall (z 0.75 to 2.75) and on a ceiling over a ground of 4 x 4 m.
std::vector<Point> cie_points() {
  std::vector<Point> points;
  for (int k = 0; k < 5; ++k) points.push_back({{2, 0, 0.75 + 0.5 * k}, {0, 1, 0}});
  for (int k = 0; k < 8; ++k) points.push_back({{2, 0.25 + 0.5 * k, 3}, kDown});
  return points;
}

// As printed: the ground's exitance is even. `side_m`: 4 in the standard.
CaseResult even_ground(double side_m, const Effort& effort) {
  const double low = 2.0 - 0.5 * side_m;
  const Rectangle ground{{low, low, 0}, {side_m, 0, 0}, {0, side_m, 0}, kUp};
  Scene scene;
  scene.add_luminous(ground, 1000.0);
  const std::vector<Point> points = cie_points();
  std::vector<double> exact;
  for (const Point& p : points) {
    exact.push_back(1000.0 *
                    rectangle_factor(p.position_m, p.normal, ground.corner, ground.u, ground.v));
  }
  CaseResult result;
  for (const char* label : {"B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N"}) {
    result.labels.emplace_back(label);
  }
  result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.01);
  return result;
}

// A lamp over a ground in black surroundings: the reflected part alone.
CaseResult lit_ground(const glm::dvec3& lamp, double rho, const std::vector<Point>& points,
                      std::uint64_t paths, double widest, const Effort& effort) {
  const double cd = 500.0;
  const Rectangle ground{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, kUp};
  Scene scene;
  scene.add_box({0, 0, 0}, {4, 4, 3}, {0, 0, 0, 0, rho, 0});
  scene.add_luminaire(isotropic_web(cd), lamp);
  const DirectLight direct = isotropic_light(cd, lamp);
  const SurfaceValue exitance = [&](const glm::dvec3& y) { return rho * direct(y, kUp); };
  std::vector<double> exact;
  for (const Point& p : points) {
    exact.push_back(reflected_lx(ground, exitance, {lamp}, p.position_m, p.normal));
  }
  Effort more = effort;
  more.paths = paths;
  CaseResult result;
  result.add_points(solve(scene, points, more), points, exact, 1e-5, widest, Part::indirect);
  return result;
}

}  // namespace

std::vector<SelftestCase> reflection_cases() {
  return {
      {"cie171-5.6", "reflection", "Evenly lit ground of 4 x 4 m; wall and ceiling points",
       "CIE 171:2006, 5.6; Lambert's contour formula",
       [](const Effort& e) { return even_ground(4.0, e); }},
      {"cie171-5.6-large", "reflection", "The same points over a ground of 500 x 500 m",
       "after CIE 171:2006, 5.6; Lambert's contour formula",
       [](const Effort& e) { return even_ground(500.0, e); }},
      {"lit-ground", "reflection", "Ground lit by a lamp in black surroundings; the CIE points",
       "E = integral of rho E / pi cos cos / d^2, by Gauss quadrature",
       [](const Effort& e) {
         return lit_ground({1.4, 2.3, 2.0}, 0.3, cie_points(), 4096, 0.008, e);
       }},
      {"lamp-near-ground", "reflection", "Lamp 30 mm over the ground, points 1 mm to 1 m from it",
       "E = integral of rho E / pi cos cos / d^2, by Gauss quadrature", [](const Effort& e) {
         return lit_ground({2, 2, 0.03}, 0.8,
                           {{{2.0, 2.5, 0.5}, kDown},
                            {{2.06, 2.0, 0.1}, kDown},
                            {{2.2, 2.0, 0.05}, {-1, 0, 0}},
                            {{3.0, 2.0, 0.001}, {-1, 0, 0}},
                            {{1.0, 1.0, 1.0}, kDown}},
                           8192, 0.02, e);
       }}};
}

}  // namespace cli::selftest
