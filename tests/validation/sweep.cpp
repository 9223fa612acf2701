#include "tests/validation/sweep.h"

#include "calc/base/elementary.h"
#include "calc/base/statistics.h"
#include "calc/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace validation {

using namespace cli::selftest;

namespace {

constexpr double kCd = 100.0;
const glm::dvec3 kRoom(4, 3, 2.5), kLamp(1.4, 1.1, 1.9);

SweepStep step_of(double value, const Solution& solution, const std::vector<double>& replicates,
                  double truth, double known_to) {
  SweepStep step;
  step.value = value;
  step.known_to = known_to;
  step.rays = static_cast<double>(solution.rays);
  step.said = solution.problem;
  if (!step.said.empty()) return step;
  const calc::Estimate e = calc::t_interval(replicates, 0.95);
  step.deviation = e.value / truth - 1.0;
  step.half_width = e.half_width() / truth;
  if (!solution.field.unseen.empty() && solution.field.unseen[0] != 0) {
    step.said = "0 lx, marked as not seen by any sample";
  } else if (!solution.field.largest_share.empty() && solution.field.largest_share[0] > 0.5f) {
    step.said = "a number, marked as resting on one sample";
  }
  return step;
}

// Of a face along x, the parts between ascending places; any other face whole.
std::vector<Rectangle> cut_along_x(const Rectangle& face, const std::vector<double>& cuts) {
  std::vector<Rectangle> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    Rectangle part = face;
    const double length = cuts[k + 1] - cuts[k];
    part.corner.x = cuts[k];
    if (face.u.x > 0.0) {
      part.u = {length, 0, 0};
    } else if (face.v.x > 0.0) {
      part.v = {length, 0, 0};
    } else {
      return {face};
    }
    parts.push_back(part);
  }
  return parts;
}

// Places along a corridor, closer together near its middle.
std::vector<double> corridor_cuts(double length) {
  std::vector<double> half = {0.0};
  for (double step = 0.5; half.back() + step<0.5 * length; step *= half.size()> 4 ? 1.4 : 1.0) {
    half.push_back(half.back() + step);
  }
  half.push_back(0.5 * length);
  std::vector<double> cuts;
  for (std::size_t k = half.size(); k-- > 1;) cuts.push_back(0.5 * length - half[k]);
  for (const double h : half) cuts.push_back(0.5 * length + h);
  return cuts;
}

// Mean indirect illuminance of all surfaces of a closed box: rho Phi / (S (1 - rho)).
// The faces are cut across x at the places given, so that points lie dense where light changes.
SweepStep closed_box(double value, const glm::dvec3& size, const glm::dvec3& lamp, double rho,
                     std::uint64_t paths, const std::vector<double>& cuts, int n,
                     const Effort& effort) {
  Scene scene;
  scene.add_box({0, 0, 0}, size, rho);
  scene.add_luminaire(isotropic_web(kCd), lamp);
  std::vector<Point> points;
  std::vector<double> weights;
  for (const Rectangle& face : faces_of_box({0, 0, 0}, size)) {
    for (const Rectangle& part : cut_along_x(face, cuts)) {
      for (const AreaPoint& p : points_on(part, n)) {
        points.push_back({p.position_m, p.normal});
        weights.push_back(p.area_m2 / scene.surface_m2());
      }
    }
  }
  Effort chosen = effort;
  chosen.paths = paths;
  const Solution solution = solve(scene, points, chosen);
  return step_of(value, solution,
                 solution.problem.empty() ? solution.replicates(weights, Part::indirect)
                                          : std::vector<double>{},
                 rho * 4.0 * calc::kPi * kCd / (scene.surface_m2() * (1.0 - rho)), 1e-3);
}

// One white wall in a black room, seen from a point: total illuminance.
SweepStep white_wall(double value, const glm::dvec3& shift, double cd, const Point& point,
                     const Effort& effort) {
  constexpr double kRho = 0.9;
  Scene scene;
  scene.add_box({0, 0, 0}, kRoom, {kRho, 0, 0, 0, 0, 0});
  scene.add_luminaire(isotropic_web(cd), kLamp);
  const DirectLight direct = isotropic_light(cd, kLamp);
  const Rectangle wall = faces_of_box({0, 0, 0}, kRoom)[0];
  const double truth = direct(point.position_m, point.normal) +
                       reflected_lx(
                           wall, [&](const glm::dvec3& y) { return kRho * direct(y, wall.normal); },
                           {kLamp}, point.position_m, point.normal);
  scene.move(shift);
  Effort chosen = effort;
  chosen.paths = 4096;
  const Solution solution = solve(scene, {{point.position_m + shift, point.normal}}, chosen);
  return step_of(value, solution,
                 solution.problem.empty() ? solution.replicates(0) : std::vector<double>{}, truth,
                 1e-5);
}

using StepMaker = std::function<SweepStep(double)>;

struct Plan {
  Sweep sweep;
  std::vector<double> values;
  StepMaker make;
};

std::vector<Plan> plans(const Effort& effort) {
  const Point middle{{2, 1.5, 0.75}, {-1, 0, 0}};
  return {
      {{"reflectance",
        "Reflectance of a closed room",
        "1 - rho",
        "mean indirect illuminance of all surfaces (flux balance)",
        {}},
       {0.9, 0.5, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 5e-5, 1e-5, 1e-6},
       [effort](double absorbed) {
         // About the same number of reflections in every step.
         const double wanted = std::clamp(4096.0 * absorbed, 16.0, 1024.0);
         const auto paths = std::uint64_t{1} << static_cast<int>(calc::log2(wanted));
         return closed_box(absorbed, kRoom, kLamp, 1.0 - absorbed, paths, {0.0, kRoom.x}, 6,
                           effort);
       }},
      {{"distance",
        "Distance from a white wall",
        "m",
        "illuminance of a point, facing the wall",
        {}},
       {1.0, 0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1.7e-5, 1e-5, 1e-6},
       [effort](double d) {
         return white_wall(d, glm::dvec3(0.0), kCd, {{d, 1.5, 1.2}, {-1, 0, 0}}, effort);
       }},
      {{"offset",
        "Distance of the room from the origin",
        "m",
        "illuminance of a point, facing a white wall",
        {}},
       {1.0, 1e2, 1e4, 1e5, 1e6, 1e7, 1e8},
       [effort, middle](double d) {
         return white_wall(d, {d, -d, d}, kCd, middle, effort);
       }},
      {{"intensity",
        "Intensity of the lamp",
        "cd",
        "illuminance of a point, facing a white wall",
        {}},
       {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12},
       [effort, middle](double cd) { return white_wall(cd, glm::dvec3(0.0), cd, middle, effort); }},
      {{"aspect",
        "Length of a corridor of 1 x 1 m, rho 0.7",
        "m",
        "mean indirect illuminance of all surfaces (flux balance)",
        {}},
       {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0},
       [effort](double length) {
         return closed_box(length, {length, 1, 1}, {0.5 * length, 0.4, 0.6}, 0.7, 1024,
                           corridor_cuts(length), 4, effort);
       }}};
}

}  // namespace

std::vector<Sweep> run_sweeps(const Effort& effort,
                              const std::function<void(const std::string&)>& announce) {
  std::vector<Sweep> sweeps;
  for (Plan& plan : plans(effort)) {
    for (const double value : plan.values) {
      announce(fmt::format("{} {:g} {}", plan.sweep.name, value, plan.sweep.unit));
      plan.sweep.steps.push_back(plan.make(value));
    }
    sweeps.push_back(std::move(plan.sweep));
  }
  return sweeps;
}

}  // namespace validation
