// Extremes: reflectance to the end, 1:1000, far from the origin, 1 mm, double walls, needles.

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/tools/selftest/case.h"
#include "report/tools/selftest/closed_forms.h"

#include <algorithm>
#include <cmath>

namespace cli::selftest {
namespace {

using calc::kPi;

constexpr double kCd = 100.0, kRho = 0.6;
constexpr double kLamp_lm = 4.0 * kPi * kCd;
const glm::dvec3 kRoom(4, 3, 2.5), kLamp(1.4, 1.1, 1.9);

// Points of the plain room where meshes and offsets go wrong first.
std::vector<Point> room_points() {
  return {{{2, 1.5, 0.75}, kUp},
          {{2, 1.5, 0}, kUp},                 // exactly on a surface
          {{0.001, 1.5, 0.001}, {-1, 0, 0}},  // 1 mm from an edge, facing the wall
          {{0.001, 0.001, 0.001}, kUp},       // 1 mm from a corner
          {{0.3, 1.0, 1.25}, kDown}};
}

// The plain room by the matrix solution; solved once for all cases.
struct RoomTruth {
  std::vector<double> total_lx, known_to;

  RoomTruth() {
    const DirectLight direct = isotropic_light(kCd, kLamp);
    const BoxReference reference(kRoom, same_on_all(kRho), direct);
    for (const Point& p : room_points()) {
      const KnownValue indirect = reference.indirect_lx(p.position_m, p.normal);
      total_lx.push_back(indirect.value + direct(p.position_m, p.normal));
      known_to.push_back(indirect.known_to * indirect.value / total_lx.back());
    }
  }
};

void compare_with_room(const Scene& scene, const glm::dvec3& shift, double scale,
                       const Effort& effort, CaseResult& result) {
  static const RoomTruth truth;
  std::vector<Point> points = room_points();
  std::vector<double> exact = truth.total_lx;
  for (Point& p : points) p.position_m += shift;
  for (double& lx : exact) lx *= scale;
  Effort more = effort;
  more.paths = 2048;
  result.labels = {"work plane", "on the floor", "1 mm from an edge", "1 mm from a corner",
                   "facing down"};
  result.known_each = truth.known_to;
  result.add_points(solve(scene, points, more), points, exact, 0.0, 0.04);
}

Scene plain_room(double cd = kCd) {
  Scene scene;
  scene.add_box({0, 0, 0}, kRoom, kRho);
  scene.add_luminaire(isotropic_web(cd), kLamp);
  return scene;
}

CaseResult shifted_rooms(const Effort& effort) {
  CaseResult result;
  for (const double shift : {0.0, 1e3, 1e6}) {
    Scene scene = plain_room();
    scene.move(glm::dvec3(shift, -shift, 0.5 * shift));
    compare_with_room(scene, glm::dvec3(shift, -shift, 0.5 * shift), 1.0, effort, result);
  }
  return result;
}

CaseResult intensities(const Effort& effort) {
  CaseResult result;
  for (const double cd : {1e-6, 1e9}) {
    compare_with_room(plain_room(cd), glm::dvec3(0.0), cd / kCd, effort, result);
  }
  return result;
}

// Every wall twice, the second time with the other winding.
CaseResult double_walls(const Effort& effort) {
  Scene scene = plain_room();
  scene.add_box({0, 0, 0}, kRoom, kRho);
  for (const Rectangle& face : faces_of_box({0, 0, 0}, kRoom)) {
    scene.add_quad(face.corner, face.v, face.u, kRho);
  }
  CaseResult result;
  compare_with_room(scene, glm::dvec3(0.0), 1.0, effort, result);
  return result;
}

// Floor and one wall of strips 1e4 times as long as wide; triangles of no area and twice the same.
CaseResult needles(const Effort& effort) {
  constexpr int kStrips = 7500;
  Scene scene;
  for (const Rectangle& face : faces_of_box({0, 0, 0}, kRoom)) {
    if (face.normal != kUp) scene.add_quad(face.corner, face.u, face.v, kRho);
  }
  for (int k = 0; k < kStrips; ++k) {
    scene.add_quad({0, kRoom.y * k / kStrips, 0}, {kRoom.x, 0, 0}, {0, kRoom.y / kStrips, 0}, kRho);
  }
  scene.add_triangle({1, 1, 1}, {1, 1, 1}, {2, 1, 1}, kRho);
  scene.add_triangle({1, 1, 1}, {1.5, 1, 1}, {2, 1, 1}, kRho);
  scene.add_triangle({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, kRho);
  scene.add_luminaire(isotropic_web(kCd), kLamp);
  CaseResult result;
  compare_with_room(scene, glm::dvec3(0.0), 1.0, effort, result);
  return result;
}

// sum of (1 - rho) E A = Phi, face by face, on 6 x 6 points per face.
CaseResult high_reflectance(const Effort& effort) {
  CaseResult result;
  for (const double rho : {0.99, 0.999, 0.9995}) {
    Scene scene;
    scene.add_box({0, 0, 0}, kRoom, rho);
    scene.add_luminaire(isotropic_web(kCd), kLamp);
    std::vector<Point> points;
    std::vector<double> weights;
    for (const Rectangle& face : faces_of_box({0, 0, 0}, kRoom)) {
      for (const AreaPoint& p : points_on(face, 4)) {
        points.push_back({p.position_m, p.normal});
        weights.push_back((1.0 - rho) * p.area_m2);
      }
    }
    Effort chosen = effort;
    chosen.paths = rho > 0.9992 ? 32 : rho > 0.995 ? 64 : 256;
    // The indirect part alone: its absorbed flux is rho Phi.
    result.add_sum(solve(scene, points, chosen),
                   "absorbed of reflected light, rho = " + std::to_string(rho), "lm", weights,
                   rho * kLamp_lm, 1e-3, 0.035, Part::indirect);
  }
  return result;
}

// Walls that absorb nothing over a floor that does: all light ends in the floor.
CaseResult white_walls(const Effort& effort) {
  Scene scene;
  scene.add_box({0, 0, 0}, kRoom, {1, 1, 1, 1, 0.2, 1});
  scene.add_luminaire(isotropic_web(kCd), kLamp);
  std::vector<Point> points;
  std::vector<double> weights;
  for (const AreaPoint& p : points_on(faces_of_box({0, 0, 0}, kRoom)[4], 12)) {
    points.push_back({p.position_m, p.normal});
    weights.push_back(0.8 * p.area_m2);
  }
  CaseResult result;
  result.add_sum(solve(scene, points, effort), "absorbed by the floor", "lm", weights, kLamp_lm,
                 1e-3, 0.02);
  return result;
}

CaseResult black_room(const Effort& effort) {
  Scene scene;
  scene.add_box({0, 0, 0}, kRoom, 0.0);
  scene.add_luminaire(isotropic_web(kCd), kLamp);
  std::vector<double> exact;
  for (const Point& p : room_points()) {
    exact.push_back(isotropic_light(kCd, kLamp)(p.position_m, p.normal));
  }
  CaseResult result;
  result.add_points(solve(scene, room_points(), effort), room_points(), exact, 0.0, 0.0);
  Scene dark;  // light upwards only, everything black: exactly 0, and nothing sampled
  dark.add_box({0, 0, 0}, kRoom, 0.0);
  dark.add_luminaire(calc::PhotometricWeb::make({0.0}, {0.5 * kPi, kPi}, {200, 200}, {}, {}),
                     {1, 1, 2});
  const std::vector<Point> below = {{{2, 1.5, 0.75}, kUp}, {{1, 1, 1.9}, kUp}};
  result.add_points(solve(dark, below, effort), below, {0.0, 0.0}, 0.0, 0.0);
  return result;
}

// One white wall in a black room: one reflection, also right beside the wall.
CaseResult white_wall(const glm::dvec3& lamp, const std::vector<Point>& points, std::uint64_t paths,
                      const Effort& effort) {
  const double rho = 0.9;
  Scene scene;
  scene.add_box({0, 0, 0}, kRoom, {rho, 0, 0, 0, 0, 0});
  scene.add_luminaire(isotropic_web(kCd), lamp);
  const DirectLight direct = isotropic_light(kCd, lamp);
  const Rectangle wall = faces_of_box({0, 0, 0}, kRoom)[0];
  const SurfaceValue exitance = [&](const glm::dvec3& y) { return rho * direct(y, wall.normal); };
  std::vector<double> exact;
  for (const Point& p : points) {
    exact.push_back(direct(p.position_m, p.normal) +
                    reflected_lx(wall, exitance, {lamp}, p.position_m, p.normal));
  }
  CaseResult result;
  Effort more = effort;
  more.paths = paths;
  result.add_points(solve(scene, points, more), points, exact, 1e-4, 0.02);
  return result;
}

// Half the intensity 4 degrees off the axis, 5 m above the floor: the reflected light of its spot.
CaseResult narrow_spot(const Effort& effort) {
  constexpr int kSteps = 240;  // to 12 degrees
  std::vector<double> gamma_rad, cd;
  for (int k = 0; k <= kSteps; ++k) {
    const double degrees = 12.0 * k / kSteps;
    gamma_rad.push_back(calc::kRadiansPerDegree * degrees);
    cd.push_back(k == kSteps ? 0.0 : 50000.0 * calc::pow(0.5, degrees * degrees / 16.0));
  }
  const glm::dvec3 lamp(3, 3, 5);
  Scene scene;
  scene.add_box({0, 0, 0}, {6, 6, 5.5}, {0, 0, 0, 0, 0.5, 0});
  scene.add_luminaire(calc::PhotometricWeb::make({0.0}, gamma_rad, cd, {}, {}), lamp);
  const SurfaceValue exitance = [&](const glm::dvec3& y) {
    const glm::dvec3 w = lamp - y;
    const double d = glm::length(w), degrees = calc::acos(w.z / d) / calc::kRadiansPerDegree;
    return degrees < 12.0
               ? 0.5 * 50000.0 * calc::pow(0.5, degrees * degrees / 16.0) * w.z / (d * d * d)
               : 0.0;
  };
  const std::vector<Point> points = {
      {{4, 3, 2}, kDown}, {{3.5, 3, 0.3}, kDown}, {{3.05, 3, 0.05}, kDown}, {{5.9, 0.1, 1}, kDown}};
  std::vector<double> exact;  // the spot in parts, so that it is not missed between cells
  for (const Point& p : points) {
    double sum = 0.0;
    for (int i = 0; i < 24; ++i) {
      for (int k = 0; k < 24; ++k) {
        const Rectangle part{{1.8 + 0.1 * i, 1.8 + 0.1 * k, 0}, {0.1, 0, 0}, {0, 0.1, 0}, kUp};
        sum += reflected_lx(part, exitance, {}, p.position_m, p.normal);
      }
    }
    exact.push_back(sum);
  }
  CaseResult result;
  Effort more = effort;
  more.paths = 4096;
  result.add_points(solve(scene, points, more), points, exact, 1e-3, 0.005);
  return result;
}

// 1000 luminaires, one of them a thousand times stronger; the direct light of all.
CaseResult thousand_luminaires(const Effort& effort) {
  const calc::PhotometricWeb small = isotropic_web(1000.0 / (4.0 * kPi));
  const calc::PhotometricWeb large = isotropic_web(1e6 / (4.0 * kPi));
  Scene scene;
  scene.add_quad({0, 0, 0}, {80, 0, 0}, {0, 50, 0}, 0.3);
  const std::vector<Point> points = {
      {{70, 10, 0.75}, kUp}, {{41, 21, 3}, kDown}, {{70, 10, 3}, kDown}};
  std::vector<double> exact(3, 0.0);
  std::vector<glm::dvec3> hot;
  for (int k = 0; k < 1000; ++k) {
    const glm::dvec3 at(1.0 + 2 * (k % 40), 1.0 + 2 * (k / 40), 6.0);
    hot.push_back(at);
  }
  scene.add_luminaire(large, hot[420]);
  scene.add_luminaire(small, hot[0]);
  for (std::size_t k = 1; k < hot.size(); ++k) {
    if (k != 420) scene.repeat_luminaire(hot[k]);
  }
  const SurfaceValue direct = [&](const glm::dvec3& y) {
    double sum = 0.0;
    for (std::size_t k = 0; k < hot.size(); ++k) {
      const glm::dvec3 w = hot[k] - y;
      const double d2 = glm::dot(w, w);
      sum += (k == 420 ? 1e6 : 1000.0) / (4.0 * kPi) * w.z / (d2 * std::sqrt(d2));
    }
    return sum;
  };
  const SurfaceValue exitance = [&](const glm::dvec3& y) { return 0.3 * direct(y); };
  exact[0] = direct(points[0].position_m);
  for (const std::size_t i : {1u, 2u}) {
    // Exitance varies over metres, the height of the lamps: cells of 5 m are fine enough.
    double sum = 0.0;
    for (int a = 0; a < 16; ++a) {
      for (int b = 0; b < 10; ++b) {
        sum += reflected_lx({{5.0 * a, 5.0 * b, 0}, {5, 0, 0}, {0, 5, 0}, kUp}, exitance, {},
                            points[i].position_m, points[i].normal);
      }
    }
    exact[i] = sum;
  }
  CaseResult result;
  Effort more = effort;
  more.paths = 256;
  result.add_points(solve(scene, points, more), points, exact, 5e-4, 0.04);
  return result;
}

// 1000 x 1 x 1 m, all surfaces alike and shining: E = M / (1 - rho) even there.
CaseResult long_corridor(const Effort& effort) {
  constexpr double kExitance = 10.0, kCorridorRho = 0.5;
  Scene scene;
  scene.add_box({0, 0, 0}, {1000, 1, 1}, kCorridorRho);
  for (Rectangle face : faces_of_box({0, 0, 0}, {1000, 1, 1})) {
    face.corner += 1e-5 * face.normal;
    scene.add_luminous(face, kExitance);
  }
  const std::vector<Point> points = {
      {{500, 0.5, 0.5}, kUp}, {{1, 0.2, 0.002}, {1, 0, 0}}, {{999.5, 0.5, 0.0}, kUp}};
  CaseResult result;
  Effort more = effort;
  more.paths = 8192;
  result.add_points(solve(scene, points, more), points,
                    std::vector<double>(3, kExitance / (1.0 - kCorridorRho)), 1e-3, 0.1);
  return result;
}

}  // namespace

std::vector<SelftestCase> extreme_cases() {
  return {
      {"far-from-origin", "extreme", "A room at the origin, 1 km and 1000 km away from it",
       "own matrix solution", shifted_rooms},
      {"intensities", "extreme", "The room with a lamp of 1e-6 cd and of 1e9 cd",
       "own matrix solution; light is linear", intensities},
      {"double-walls", "extreme", "The room with every wall three times in the same place",
       "own matrix solution", double_walls},
      {"needles", "extreme", "The room with a floor of triangles 1:10,000, and some of no area",
       "own matrix solution", needles},
      {"rho-0", "extreme", "Black room: direct light alone; uplight in it: exactly nothing",
       "inverse square and cosine law", black_room},
      {"rho-to-0.9995", "extreme", "Reflectance 0.99, 0.999 and 0.9995 in a closed room",
       "flux balance", high_reflectance},
      {"rho-1-and-a-floor", "extreme", "Walls that absorb nothing over a floor that does",
       "flux balance", white_walls},
      {"one-white-wall", "extreme", "One white wall in a black room, points to 5 mm from it",
       "Gauss quadrature",
       [](const Effort& e) {
         return white_wall(kLamp,
                           {{{3, 1.5, 0.75}, kUp},
                            {{0.01, 1.5, 0}, kUp},
                            {{0.5, 1, 1}, {-1, 0, 0}},
                            {{0.005, 2, 1.2}, kDown}},
                           4096, e);
       }},
      {"just-off-a-wall", "extreme", "The same, as near to surfaces as points may be, and on them",
       "Gauss quadrature",
       [](const Effort& e) {
         return white_wall(kLamp,
                           {{{1.8e-5, 1.5, 1.2}, {-1, 0, 0}},
                            {{1.8e-5, 0.7, 0.9}, glm::normalize(glm::dvec3(-1, 0, 1))},
                            {{1e-5, 1.5, 1.2}, kUp},
                            {{1, 1.5, 0}, kUp},
                            {{4, 1, 1}, {-1, 0, 0}}},
                           4096, e);
       }},
      {"lamp-at-wall", "extreme", "Lamp 30 mm from a white wall", "Gauss quadrature",
       [](const Effort& e) {
         return white_wall({0.03, 1.5, 1.5},
                           {{{2, 1.5, 0.75}, kUp},
                            {{0.06, 1.5, 1.4}, kUp},
                            {{0.005, 1.5, 1.45}, kUp},
                            {{0.1, 1.5, 1.5}, {-1, 0, 0}}},
                           8192, e);
       }},
      {"narrow-spot", "extreme", "Spot of 8 degrees, 5 m above the floor: what its spot reflects",
       "Gauss quadrature", narrow_spot},
      {"thousand-luminaires", "extreme", "1000 luminaires, one of them of 1e6 lm",
       "inverse square law; Gauss quadrature", thousand_luminaires},
      {"corridor-1-to-1000", "extreme", "Corridor 1000 x 1 x 1 m, all surfaces shine and reflect",
       "E = M / (1 - rho) everywhere", long_corridor}};
}

}  // namespace cli::selftest
