// Area sources: luminous openings of luminaires against configuration factors.

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/tools/selftest/case.h"
#include "report/tools/selftest/closed_forms.h"

#include <cmath>

namespace cli::selftest {
namespace {

using calc::kPi;

CaseResult panel(const Rectangle& source, double exitance, const std::vector<Point>& points,
                 double widest, const Effort& effort) {
  Scene scene;
  scene.add_luminous(source, exitance);
  std::vector<double> exact;
  for (const Point& p : points) {
    exact.push_back(exitance *
                    rectangle_factor(p.position_m, p.normal, source.corner, source.u, source.v));
  }
  CaseResult result;
  result.add_points(solve(scene, points, effort), points, exact, 0.0, widest);
  return result;
}

// CIE 171:2006, 5.3. Its printed table is off by up to 0.25 % (that of a subdivided source, as it
// seems); the formula is not.
CaseResult cie_area_source(const Effort& effort) {
  std::vector<Point> points;
  for (int k = 0; k < 6; ++k) points.push_back({{2, 0, 2.75 - 0.5 * k}, {0, 1, 0}});
  for (int k = 0; k < 8; ++k) points.push_back({{2, 0.25 + 0.5 * k, 0}, kUp});
  return panel({{1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0}, kDown}, 1000.0 * kPi, points, 5e-3, effort);
}

CaseResult panel_near_and_far(const Effort& effort) {
  const std::vector<Point> points = {
      {{0, 0, 0}, kUp},          {{0.3, 0.6, 0}, kUp},          {{2, 0.6, 0}, kUp},
      {{2, 0.6, 1}, {-1, 0, 0}}, {{1, 2, 0.5}, {-0.6, 0, 0.8}}, {{0.3, 0.6, 2}, kUp},
      {{0.3, 0.6, 2.049}, kUp}};
  return panel({{0, 0, 2.05}, {0, 1.2, 0}, {0.6, 0, 0}, kDown}, 3000.0 * kPi, points, 5e-3, effort);
}

CaseResult strip(const Effort& effort) {
  const std::vector<Point> points = {{{0, 0, 0}, kUp},
                                     {{0, 0.5, 0}, kUp},
                                     {{0, 2, 0}, kUp},
                                     {{0, 0, 0.9}, kUp},
                                     {{0, 0, 0.999}, kUp}};
  CaseResult result =
      panel({{-0.0005, -0.5, 1}, {0, 1, 0}, {0.001, 0, 0}, kDown}, 1e6, points, 0.01, effort);
  return result;
}

CaseResult luminous_wall(const Effort& effort) {
  const std::vector<Point> points = {{{2, 0.001, 1.5}, {0, -1, 0}},
                                     {{2, 0.001, 0.001}, {0, -1, 0}},
                                     {{0.001, 0.001, 0.001}, {0, -1, 0}},
                                     {{2, 0.001, 0}, kUp},
                                     {{0.001, 0.001, 0}, kUp},
                                     {{2, 1, 0}, kUp}};
  return panel({{0, 0, 0}, {0, 0, 3}, {4, 0, 0}, {0, 1, 0}}, 1000.0, points, 0.01, effort);
}

CaseResult disc(const Effort& effort) {
  const double r = 0.5, h = 2.0, exitance = 5000.0 * kPi;
  Scene scene;
  scene.add_luminaire(
      lambert_web(5000.0 * kPi * r * r, {calc::OpeningShape::disk, 2 * r, 2 * r, 0.0}), {0, 0, h});
  const std::vector<Point> points = {
      {{0, 0, 0}, kUp},   {{0.5, 0, 0}, kUp},      {{2, 0, 0}, kUp},         {{0, 5, 0}, kUp},
      {{0, 0, 1.9}, kUp}, {{1, 0, 1}, {-1, 0, 0}}, {{3, 0, 1.5}, {-1, 0, 0}}};
  std::vector<double> exact;
  for (const Point& p : points) {
    const double below = h - p.position_m.z;
    const double offset = glm::length(glm::dvec2(p.position_m));
    exact.push_back(exitance * (p.normal == kUp ? disc_factor_parallel(r, below, offset)
                                                : disc_factor_perpendicular(r, below, offset)));
  }
  CaseResult result;
  result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.01);
  return result;
}

CaseResult sphere(const Effort& effort) {
  const double r = 0.2, luminance = 8000.0;
  const glm::dvec3 centre(0, 0, 2);
  Scene scene;
  scene.add_luminaire(
      isotropic_web(luminance * kPi * r * r, {calc::OpeningShape::ellipsoid, 2 * r, 2 * r, 2 * r}),
      centre);
  const std::vector<Point> points = {
      {{0, 0, 0}, kUp},   {{3, 0, 0}, kUp},   {{3, 0, 2}, {-1, 0, 0}}, {{1, 0, 2}, kUp},
      {{1, 0, 1.9}, kUp}, {{1, 0, 2.3}, kUp}, {{0, 0, 1.799}, kUp}};
  std::vector<double> exact;
  for (const Point& p : points) {
    const glm::dvec3 w = centre - p.position_m;
    const double d = glm::length(w);
    exact.push_back(kPi * luminance * sphere_factor(r, d, calc::acos(glm::dot(w, p.normal) / d)));
  }
  CaseResult result;
  result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.06);
  return result;
}

}  // namespace

std::vector<SelftestCase> area_cases() {
  return {
      {"cie171-5.3", "area", "Square of 1 m in a ceiling; six wall and eight floor points",
       "CIE 171:2006, 5.3; Lambert's contour formula (the printed table is off by up to 0.25 %)",
       cie_area_source},
      {"panel", "area", "Panel 0.6 x 1.2 m: centre, corner, beside, upright, 50 mm and 1 mm below",
       "Lambert's contour formula", panel_near_and_far},
      {"strip-1-to-1000", "area", "Strip of 1 mm x 1 m, from 1 m down to 1 mm away",
       "Lambert's contour formula", strip},
      {"luminous-wall", "area", "Points 1 mm from a luminous wall, its edge and its corner",
       "Lambert's contour formula", luminous_wall},
      {"disc", "area", "Disc of 1 m, parallel and upright receivers", "Howell B-12, B-13", disc},
      {"sphere", "area", "Luminous sphere of 0.4 m, whole and cut by the horizon, 1 mm away",
       "Howell B-38, B-39", sphere}};
}

}  // namespace cli::selftest
