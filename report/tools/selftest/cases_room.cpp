// Closed rooms: averages by the flux balance, points by a matrix solution, furnaces and plates.

#include "calc/base/units.h"
#include "report/tools/selftest/case.h"
#include "report/tools/selftest/closed_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cli::selftest {
namespace {

using calc::kPi;

// Closed by a flux balance: the mean indirect illuminance over all surfaces is rho Phi / (S (1 -
// rho)) whatever the shape. rule: over all surfaces; flux_lm: in closed form, not what the program
// makes of the lamp's table.
void add_balance(const Scene& scene, double flux_lm, const std::vector<AreaPoint>& rule, double rho,
                 double known_to, std::uint64_t paths, double widest, const Effort& effort,
                 CaseResult& result) {
  std::vector<Point> points;
  std::vector<double> weights;
  const double area = scene.surface_m2();
  for (const AreaPoint& p : rule) {
    points.push_back({p.position_m, p.normal});
    weights.push_back(p.area_m2 / area);
  }
  Effort chosen = effort;
  chosen.paths = paths;
  result.add_sum(solve(scene, points, chosen), fmt::format("average indirect, rho = {}", rho), "lx",
                 weights, rho * flux_lm / (area * (1.0 - rho)), known_to, widest, Part::indirect);
}

std::vector<AreaPoint> rule_over_box(const glm::dvec3& low, const glm::dvec3& size, int n) {
  std::vector<AreaPoint> all;
  for (const Rectangle& face : faces_of_box(low, size)) {
    for (const AreaPoint& p : points_on(face, n)) all.push_back(p);
  }
  return all;
}

// CIE 171:2006, 5.8: cube of 4 m, 10000 lm in its middle. It is an average over all surfaces, not a
// value at points; its printed table is rounded to three digits.
CaseResult cie_cube(const Effort& effort) {
  CaseResult result;
  for (const double rho : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95}) {
    Scene scene;
    scene.add_box({0, 0, 0}, {4, 4, 4}, rho);
    scene.add_luminaire(isotropic_web(10000.0 / (4.0 * kPi)), {2, 2, 2});
    // 6 x 6 points per face miss the bend at the edges by 2e-4, as the matrix solution shows.
    add_balance(scene, 10000.0, rule_over_box({0, 0, 0}, {4, 4, 4}, 6), rho, 4e-4, 512, 0.01,
                effort, result);
  }
  return result;
}

CaseResult l_shape(const Effort& effort) {
  const glm::dvec2 outline[6] = {{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 4}, {0, 4}};
  CaseResult result;
  for (const double rho : {0.3, 0.7}) {
    Scene scene;
    std::vector<AreaPoint> rule;
    const auto add = [&](const Rectangle& r) {
      scene.add_quad(r.corner, r.u, r.v, rho);
      for (const AreaPoint& p : points_on(r, 8)) rule.push_back(p);
    };
    for (int k = 0; k < 6; ++k) {
      const glm::dvec2 a = outline[k], b = outline[(k + 1) % 6];
      const glm::dvec3 along(b - a, 0.0);
      add({{a, 0.0}, along, {0, 0, 3}, glm::normalize(glm::cross(kUp, along))});
    }
    for (const double z : {0.0, 3.0}) {
      const glm::dvec3 normal = z == 0.0 ? kUp : kDown;
      add({{0, 0, z}, {3, 0, 0}, {0, 2, 0}, normal});
      add({{3, 0, z}, {3, 0, 0}, {0, 2, 0}, normal});
      add({{0, 2, z}, {3, 0, 0}, {0, 2, 0}, normal});
    }
    scene.add_luminaire(isotropic_web(5000.0 / (4.0 * kPi)), {5, 1, 2});
    add_balance(scene, 5000.0, rule, rho, 2e-3, 2048, 0.01, effort, result);
  }
  return result;
}

// A sphere of 320 facets; six points per facet are exact for polynomials of degree 4. [Dunavant85]
// On facets that meet at such blunt edges light hardly varies.
CaseResult integrating_sphere(const Effort& effort) {
  constexpr double kWeight[2] = {0.223381589678011, 0.109951743655322};
  constexpr double kApex[2] = {0.108103018168070, 0.816847572980459};
  CaseResult result;
  for (const double rho : {0.5, 0.9, 0.98}) {
    Scene scene;
    std::vector<AreaPoint> rule;
    const auto facet = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
      scene.add_triangle(a, b, c, rho);
      const std::array<glm::dvec3, 3> p{a, b, c};
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const glm::dvec3 inward = glm::normalize(glm::dot(normal, a) > 0.0 ? -normal : normal);
      for (std::size_t ring = 0; ring < 2; ++ring) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double rest = 0.5 * (1.0 - kApex[ring]);
          rule.push_back({kApex[ring] * p[k] + rest * (p[(k + 1) % 3] + p[(k + 2) % 3]), inward,
                          0.5 * glm::length(normal) * kWeight[ring]});
        }
      }
    };
    // Octahedron, each face in 4^2 parts, corners on the sphere of 1.5 m.
    constexpr int kParts = 6;
    for (int octant = 0; octant < 8; ++octant) {
      const glm::dvec3 sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
      const auto corner = [&](int i, int j) {
        return 1.5 * glm::normalize(sign * glm::dvec3(i, j, kParts - i - j));
      };
      for (int i = 0; i < kParts; ++i) {
        for (int j = 0; i + j < kParts; ++j) {
          facet(corner(i, j), corner(i + 1, j), corner(i, j + 1));
          if (i + j + 1 < kParts) facet(corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1));
        }
      }
    }
    scene.add_luminaire(isotropic_web(100.0), {0.4, -0.3, 0.5});
    add_balance(scene, 4.0 * kPi * 100.0, rule, rho, 1e-3, 256, 0.01, effort, result);
  }
  return result;
}

// Points of a box against the matrix solution; which says how well it is known.
CaseResult box_points(const glm::dvec3& size, const FaceReflectances& rho,
                      const calc::PhotometricWeb& web, const glm::dvec3& lamp,
                      const DirectLight& direct, const std::vector<Point>& points,
                      const Effort& effort) {
  const BoxReference reference(size, rho, direct);
  Scene scene;
  scene.add_box({0, 0, 0}, size, rho);
  scene.add_luminaire(web, lamp);
  std::vector<double> exact;
  CaseResult result;
  for (const Point& p : points) {
    const KnownValue indirect = reference.indirect_lx(p.position_m, p.normal);
    exact.push_back(indirect.value);
    result.known_each.push_back(indirect.known_to);
  }
  Effort more = effort;
  more.paths = 4096;
  result.add_points(solve(scene, points, more), points, exact, 0.0, 0.03, Part::indirect);
  return result;
}

CaseResult cube_points(const Effort& effort) {
  const double cd = 10000.0 / (4.0 * kPi);
  return box_points({4, 4, 4}, same_on_all(0.5), isotropic_web(cd), {2, 2, 2},
                    isotropic_light(cd, {2, 2, 2}),
                    {{{2, 2, 0}, kUp},
                     {{1, 1, 0}, kUp},
                     {{3.9, 3.9, 0}, kUp},
                     {{1, 1, 1}, {1, 0, 0}},
                     {{0.001, 0.001, 0.001}, kUp}},
                    effort);
}

CaseResult ordinary_room(const Effort& effort) {
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 3; ++j) points.push_back({{1 + i, 0.8 + 1.2 * j, 0.75}, kUp});
  }
  points.push_back({{0, 2, 1.2}, {1, 0, 0}});
  points.push_back({{1, 1, 2.8}, kDown});
  points.push_back({{3, 2, 0}, kUp});
  points.push_back({{0.1, 0.1, 0.1}, kUp});
  const double cd = 3000.0 / kPi;
  const glm::dvec3 lamp(3, 2, 2.79);
  return box_points({6, 4, 2.8}, {0.5, 0.5, 0.5, 0.5, 0.2, 0.7}, lambert_web(cd), lamp,
                    downlight(cd, lamp), points, effort);
}

// Every surface shines and reflects alike: E = M / (1 - rho) everywhere, in every direction.
CaseResult furnace(const glm::dvec3& size, double rho, const Effort& effort) {
  constexpr double kExitance = 100.0;
  Scene scene;
  scene.add_box({0, 0, 0}, size, rho);
  const double inset = 1e-5 * std::min({size.x, size.y, size.z});  // in front of the surfaces
  for (Rectangle face : faces_of_box({0, 0, 0}, size)) {
    face.corner += inset * face.normal;
    scene.add_luminous(face, kExitance);
  }
  const std::vector<Point> points = {
      {0.5 * size, kUp},
      {glm::dvec3(0.3, 0.6, 0.2) * size, glm::normalize(glm::dvec3(1, 1, 1))},
      {glm::dvec3(0.5, 0.001, 0.5) * size, {0, 1, 0}},
      {glm::dvec3(0.9, 0.2, 0.7) * size, {-1, 0, 0}}};
  CaseResult result;
  Effort more = effort;
  more.paths = 2048;
  result.add_points(solve(scene, points, more), points,
                    std::vector<double>(points.size(), kExitance / (1.0 - rho)), 5e-4, 0.05);
  return result;
}

// Floor and luminous ceiling 40 times as wide as far apart, walls black: in the middle nearly as
// between infinite plates, M / (1 - rho1 rho2) on the floor. The matrix solution knows the rest.
CaseResult plates(const Effort& effort) {
  const double wide = 40.0, exitance = 100.0;
  const FaceReflectances rho{0, 0, 0, 0, 0.5, 0.8};
  const Rectangle ceiling{{0, 0, 1 - 1e-5}, {0, wide, 0}, {wide, 0, 0}, kDown};
  Scene scene;
  scene.add_box({0, 0, 0}, {wide, wide, 1}, rho);
  scene.add_luminous(ceiling, exitance);
  const DirectLight direct = [&](const glm::dvec3& x, const glm::dvec3& n) {
    return x.z < ceiling.corner.z
               ? exitance * rectangle_factor(x, n, ceiling.corner, ceiling.u, ceiling.v)
               : 0.0;
  };
  const BoxReference reference({wide, wide, 1}, rho, direct);
  const std::vector<Point> points = {{{0.5 * wide, 0.5 * wide, 0.0}, kUp},
                                     {{0.4 * wide, 0.6 * wide, 0.5}, kUp},
                                     {{0.5 * wide, 0.45 * wide, 1.0}, kDown}};
  std::vector<double> exact;
  CaseResult result;
  for (const Point& p : points) {
    const double first = direct(p.position_m, p.normal);
    const KnownValue indirect = reference.indirect_lx(p.position_m, p.normal);
    exact.push_back(first + indirect.value);
    result.known_each.push_back(indirect.known_to * indirect.value / exact.back());
  }
  result.labels = {"middle of the floor", "half-way up", "middle of the ceiling"};
  Effort more = effort;
  more.paths = 8192;
  const Solution solution = solve(scene, points, more);
  result.add_points(solution, points, exact, 0.0, 0.1);
  // The walls take little more from each of the few reflections than from the direct light.
  const double infinite = exitance / (1.0 - rho[4] * rho[5]);
  const double lost =
      1.0 - rectangle_factor(points[0].position_m, kUp, ceiling.corner, ceiling.u, ceiling.v);
  result.measured.push_back({"middle of the floor, as between infinite plates", "lx", infinite,
                             4.0 * lost * infinite, solution.replicates(0), 0.1});
  return result;
}

}  // namespace

std::vector<SelftestCase> room_cases() {
  return {{"cie171-5.8", "room", "Cube of 4 m: average indirect for eleven reflectances",
           "CIE 171:2006, 5.8; flux balance rho Phi / (S (1 - rho))", cie_cube},
          {"l-shape", "room", "L-shaped room, the lamp out of sight of one leg", "flux balance",
           l_shape},
          {"integrating-sphere", "room", "Sphere of 288 facets, lamp off centre, rho to 0.98",
           "flux balance", integrating_sphere},
          {"cube-points", "room", "Cube of 4 m, rho 0.5: points, one of them 1 mm from a corner",
           "own matrix solution on a graded mesh", cube_points},
          {"room-70-50-20", "room", "Room 6 x 4 x 2.8 m, reflectances 70/50/20, downlight",
           "own matrix solution on a graded mesh", ordinary_room},
          {"furnace", "room", "Unit cube, all surfaces shine and reflect alike, rho 0.5",
           "E = M / (1 - rho) everywhere",
           [](const Effort& e) {
             return furnace({1, 1, 1}, 0.5, e);
           }},
          {"plates", "room", "Luminous ceiling 40 times as wide as high, rho 0.5 and 0.8",
           "own matrix solution; infinite plates: E = M / (1 - rho1 rho2)", plates}};
}

}  // namespace cli::selftest
