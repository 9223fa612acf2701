// Flux conservation: what a lamp sends arrives, all of it and where it belongs.

#include "calc/base/units.h"
#include "report/tools/selftest/case.h"
#include "report/tools/selftest/closed_forms.h"

#include <algorithm>
#include <cmath>

namespace cli::selftest {
namespace {

// Of the face, from a point inside the box (sr): four rectangles with a common corner.
double solid_angle(const Rectangle& face, const glm::dvec3& from) {
  const double h = std::abs(glm::dot(from - face.corner, face.normal));
  const glm::dvec3 u = glm::normalize(face.u), v = glm::normalize(face.v);
  const double a = glm::dot(from - face.corner, u), b = glm::dot(from - face.corner, v);
  const double wide = glm::length(face.u), high = glm::length(face.v);
  double sum = 0.0;
  for (const double x : {a, wide - a}) {
    for (const double y : {b, high - b}) sum += corner_solid_angle(x, y, h);
  }
  return sum;
}

// CIE 171:2006, 5.4: 10000 lm in the middle of a black room of 4 x 4 x 3 m; also the lamp's flux in
// a part of the faces near it. 32 x 32 Gauss points per face integrate to better than 1e-7.
CaseResult cie_flux(const glm::dvec3& lamp, const Effort& effort) {
  const glm::dvec3 size(4, 4, 3);
  const double cd = 10000.0 / (4.0 * calc::kPi);
  Scene scene;
  scene.add_box({0, 0, 0}, size, 0.0);
  scene.add_luminaire(isotropic_web(cd), lamp);
  const char* const names[6] = {"wall x = 0", "wall x = 4", "wall y = 0",
                                "wall y = 4", "floor",      "ceiling"};
  const auto faces = faces_of_box({0, 0, 0}, size);
  std::vector<Point> points;
  std::vector<AreaPoint> area_points;
  for (const Rectangle& face : faces) {
    for (const AreaPoint& p : points_on(face, 32)) {
      points.push_back({p.position_m, p.normal});
      area_points.push_back(p);
    }
  }
  const Solution solution = solve(scene, points, effort);
  const std::size_t per_face = points.size() / 6;
  CaseResult result;
  std::vector<double> all(points.size());
  for (std::size_t f = 0; f < 6; ++f) {
    std::vector<double> weights(points.size(), 0.0);
    for (std::size_t i = f * per_face; i < (f + 1) * per_face; ++i) {
      all[i] = area_points[i].area_m2;
      weights[i] = all[i] / faces[f].area_m2();
    }
    result.add_sum(solution, std::string("average of ") + names[f], "lx", weights,
                   cd * solid_angle(faces[f], lamp) / faces[f].area_m2(), 1e-6, 0.0);
  }
  result.add_sum(solution, "flux on all faces", "lm", all, 10000.0, 1e-6, 0.0);
  return result;
}

// The light paths' own account: what the lamp sends is absorbed, nothing escapes.
CaseResult light_budget(const Effort& effort) {
  Scene scene;
  scene.add_box({0, 0, 0}, {6, 4, 2.8}, {0.5, 0.5, 0.5, 0.5, 0.2, 0.7});
  scene.add_luminaire(lambert_web(3000.0 / calc::kPi), {2, 1, 2.8 - 0.01});
  const Solution solution = solve(scene, {{{3, 2, 0.75}, kUp}}, effort);
  CaseResult result;
  result.note(solution);
  const calc::FluxBalance& balance = solution.balance;
  const calc::Estimate& absorbed = balance.absorbed_lm;
  // 3.5: from the 95 % quantile of Student's t with 15 degrees of freedom to that of judge(); never
  // more than twice what is reached, however vague the account is.
  const double allowed_lm = std::min(3.5 * absorbed.half_width(), 30.0);
  result.measured.push_back({"lumens of the table", "lm", 3000.0, 1e-3, {balance.emitted_lm}, 0.0});
  result.measured.push_back(
      {"absorbed by all surfaces", "lm", 3000.0, allowed_lm + 1e-3, {absorbed.value}, 0.0});
  result.measured.push_back({"escaped", "lm", 0.0, 0.0, {balance.escaped_lm.value}, 0.0});
  return result;
}

}  // namespace

std::vector<SelftestCase> flux_cases() {
  return {
      {"cie171-5.4", "flux", "Lamp in the middle of a black room: average of each face",
       "CIE 171:2006, 5.4; solid angles of the faces",
       [](const Effort& e) {
         return cie_flux({2, 2, 1.5}, e);
       }},
      {"flux-off-centre", "flux", "The same lamp away from the middle", "solid angles of the faces",
       [](const Effort& e) {
         return cie_flux({1.3, 2.9, 1.9}, e);
       }},
      {"light-budget", "flux", "Light paths: emitted = absorbed, nothing escapes",
       "conservation of energy", light_budget}};
}

}  // namespace cli::selftest
