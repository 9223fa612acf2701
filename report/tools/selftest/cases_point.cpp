// Point sources: E = I(C, gamma) cos i / d^2. Nothing is sampled, so that every digit counts.

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/tools/selftest/case.h"

#include <algorithm>
#include <cmath>

namespace cli::selftest {
namespace {

using calc::kPi;

double inverse_square_lx(double cd, const glm::dvec3& source, const Point& point) {
  const glm::dvec3 w = source - point.position_m;
  return std::max(0.0, cd * glm::dot(w, point.normal)) / calc::pow(glm::length(w), 3);
}

// CIE 171:2006, 5.2: 1000 cos gamma cd, 3 m above the plane, ten points of an octant. The printed
// table was made from intensities rounded to 0.1 cd; here the formula itself is met.
CaseResult cie_point_source(const glm::dvec3& shift, const Effort& effort) {
  Scene scene;
  scene.add_luminaire(lambert_web(1000.0), glm::dvec3(0, 0, 3) + shift);
  std::vector<Point> points;
  std::vector<double> exact;
  CaseResult result;
  const double places[10][2] = {{0, 0},   {0.5, 0},   {1, 0}, {1.5, 0}, {0.5, 0.5},
                                {1, 0.5}, {1.5, 0.5}, {1, 1}, {1.5, 1}, {1.5, 1.5}};
  for (std::size_t k = 0; k < 10; ++k) {
    const double x = places[k][0], y = places[k][1], d2 = 9.0 + x * x + y * y;
    points.push_back({glm::dvec3(x, y, 0) + shift, kUp});
    exact.push_back(1000.0 * 9.0 / (d2 * d2));
    result.labels.push_back(std::string(1, static_cast<char>('A' + k)));
  }
  result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.0);
  return result;
}

// Straight lines between the angles of the table, so that interpolation adds nothing:
// I = 500 (1 - gamma / pi) (1 + 0.6 f(C)), f falls from 1 at C 0 to -1 at C 180 and rises again.
// Turned 30 degrees about the vertical and tilted 20 degrees about its own C0.
CaseResult axes_and_turns(const Effort& effort) {
  const auto f = [](double c) { return std::abs(c - kPi) * 2.0 / kPi - 1.0; };
  std::vector<double> c_rad, gamma_rad, cd;
  for (int c = 0; c <= 4; ++c) c_rad.push_back(0.5 * kPi * c);
  for (int g = 0; g <= 4; ++g) gamma_rad.push_back(0.25 * kPi * g);
  for (const double c : c_rad) {
    for (const double g : gamma_rad) {
      // One value at the poles, where C has no meaning.
      const bool is_pole = g == gamma_rad.front() || g == gamma_rad.back();
      cd.push_back(500.0 * (1.0 - g / kPi) * (1.0 + (is_pole ? 0.0 : 0.6 * f(c))));
    }
  }
  const double turn = kPi / 6.0, tilt = kPi / 9.0;
  const glm::dvec3 c0(calc::cos(turn), calc::sin(turn), 0.0);
  const glm::dvec3 level(-calc::sin(turn), calc::cos(turn), 0.0);
  const glm::dvec3 c90 = calc::cos(tilt) * level + calc::sin(tilt) * kUp;
  const glm::dvec3 back = glm::cross(c0, c90), lamp(2, 3, 2.8);
  Scene scene;
  scene.add_luminaire(calc::PhotometricWeb::make(c_rad, gamma_rad, cd, {}, {}), lamp,
                      glm::dmat3(c0, c90, back));
  const std::vector<Point> points = {{{4, 3, 0}, kUp},        {{0, 3, 0}, kUp},
                                     {{2, 5, 0}, kUp},        {{2, 1, 0}, kUp},
                                     {{3.3, 3.9, 0.75}, kUp}, {{0.5, 2.1, 1.0}, {1, 0, 0}},
                                     {{2.5, 4, 4}, kDown}};
  std::vector<double> exact;
  for (const Point& point : points) {
    const glm::dvec3 out = glm::normalize(point.position_m - lamp);
    const double x = glm::dot(out, c0), y = glm::dot(out, c90), z = glm::dot(out, back);
    double c = calc::atan2(y, x);
    if (c < 0.0) c += 2.0 * kPi;
    const double gamma = calc::acos(-z), step = 0.25 * kPi;
    // Towards a pole the C part fades out over the last step of the table.
    const double fade = std::min(1.0, std::min(gamma, kPi - gamma) / step);
    double factor = 0.0;
    if (gamma < step) {
      const double at_step = (1.0 - step / kPi) * (1.0 + 0.6 * f(c));
      factor = (1.0 - fade) * 1.0 + fade * at_step;
    } else if (gamma > kPi - step) {
      factor = fade * (step / kPi) * (1.0 + 0.6 * f(c));
    } else {
      factor = (1.0 - gamma / kPi) * (1.0 + 0.6 * f(c));
    }
    // Between two angles the table is linear, its product with 1 - gamma / pi is not curved there.
    exact.push_back(inverse_square_lx(500.0 * factor, lamp, point));
  }
  CaseResult result;
  result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.0);
  return result;
}

CaseResult isotropic_directions(const Effort& effort) {
  const double cd = 10000.0 / (4.0 * kPi);
  const glm::dvec3 lamp(1, 2, 3);
  Scene scene;
  scene.add_luminaire(isotropic_web(cd), lamp);
  const std::vector<Point> points = {{{1, 2, 0}, kUp},
                                     {{4, 6, 0}, kUp},
                                     {{4, 2, 1}, {-1, 0, 0}},
                                     {{1, -1, 1.5}, {0, 1, 0}},
                                     {{3, 2, 0.5}, glm::normalize(glm::dvec3(-1, 0, 1))},
                                     {{2, 2, 5}, kDown},
                                     {{1, 2, 0}, kDown},  // behind the point: exactly 0
                                     {{4, 2, 3}, kUp}};   // in its plane: exactly 0
  std::vector<double> exact;
  for (const Point& point : points) exact.push_back(inverse_square_lx(cd, lamp, point));
  CaseResult result;
  result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.0);
  return result;
}

CaseResult extreme_distances(const Effort& effort) {
  CaseResult result;
  const auto try_one = [&](double cd, double height, const std::vector<double>& offsets) {
    Scene scene;
    scene.add_luminaire(isotropic_web(cd), {0, 0, height});
    std::vector<Point> points;
    std::vector<double> exact;
    for (const double x : offsets) {
      points.push_back({{x, 0, 0}, kUp});
      exact.push_back(inverse_square_lx(cd, {0, 0, height}, points.back()));
    }
    result.add_points(solve(scene, points, effort), points, exact, 0.0, 0.0);
  };
  try_one(1e-6, 0.001, {0.0, 0.001, 1.0, 100.0});
  try_one(1e9, 10'000.0, {0.0, 1000.0, 30'000.0});
  return result;
}

}  // namespace

std::vector<SelftestCase> point_cases() {
  return {{"cie171-5.2", "point", "Diffuse point source over a plane, ten points",
           "CIE 171:2006, 5.2; E = I h^2 / (h^2 + r^2)^2",
           [](const Effort& e) { return cie_point_source(glm::dvec3(0.0), e); }},
          {"cie171-5.2-shifted", "point", "The same 1000 km from the origin",
           "CIE 171:2006, 5.2; everything moved by (1e6, -1e6, 1e6) m",
           [](const Effort& e) {
             return cie_point_source({1e6, -1e6, 1e6}, e);
           }},
          {"directions", "point", "Level, upright, tilted, upside-down and averted receivers",
           "inverse square and cosine law", isotropic_directions},
          {"c-gamma-axes", "point", "Asymmetric luminaire, turned and tilted",
           "a table whose interpolation is a closed form; C-gamma by CIE 121", axes_and_turns},
          {"point-distances", "point", "1 mm and 1e-6 cd; 10 to 30 km and 1e9 cd",
           "inverse square and cosine law", extreme_distances}};
}

}  // namespace cli::selftest
